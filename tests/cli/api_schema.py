"""Checks JSON of the API against its schema, without fields that the schema does not list."""
import json
import pathlib

import jsonschema


def with_bases(definitions, definition):
    """A definition of an object with the fields of those that it extends, and no others."""
    properties, required = dict(definition['properties']), list(definition.get('required', ()))
    for base in definition.get('allOf', ()):
        inherited = with_bases(definitions, definitions[name_in(base)])
        properties.update(inherited['properties'])
        required += inherited['required']
    return {'type': 'object', 'properties': properties, 'required': required, 'additionalProperties': False}


def name_in(reference):
    return reference['$ref'].removeprefix('#/$defs/')


class ApiSchema:
    def __init__(self, file):
        definitions = json.loads(pathlib.Path(file).read_text())['$defs']
        self.definitions = {name: with_bases(definitions, one) if one.get('type') == 'object' else one
                            for name, one in definitions.items()}
        self.met = set()  # names of fields
        self.validators = {}
        for name in self.definitions:
            schema = {'$ref': f'#/$defs/{name}', '$defs': self.definitions}
            jsonschema.Draft202012Validator.check_schema(schema)
            self.validators[name] = jsonschema.Draft202012Validator(schema)

    def check(self, name, value):
        """Raises a jsonschema.ValidationError if the value does not match the definition."""
        self.validators[name].validate(value)
        self._meet({'$ref': f'#/$defs/{name}'}, value)

    def not_met(self):
        """The fields that were in no value that was checked."""
        fields = {f'{name}.{field}' for name, one in self.definitions.items() for field in one.get('properties', ())}
        return fields - self.met

    def _meet(self, schema, value):
        if '$ref' in schema:
            name = name_in(schema)
            schema = self.definitions[name]
            self.met.update(f'{name}.{field}' for field in schema.get('properties', {}) if field in value)
        for option in schema.get('oneOf', ()):
            if '$ref' in option and self.validators[name_in(option)].is_valid(value):
                self._meet(option, value)
        if schema.get('type') == 'array':
            for item in value:
                self._meet(schema['items'], item)
        for field in schema.get('properties', {}).keys() & (value.keys() if isinstance(value, dict) else ()):
            self._meet(schema['properties'][field], value[field])
