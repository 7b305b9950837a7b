// Identifies this console to the server, so that it keeps the controls when the page is reloaded.

function remembered(key: string, make: () => string): string {
  const known = sessionStorage.getItem(key);
  if (known) return known;
  const made = make();
  sessionStorage.setItem(key, made);
  return made;
}

function randomId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return [...bytes].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** The secret id of this tab. */
export const clientId = remembered('rva-client', randomId);

/** The person who uses this computer, if there are no accounts. */
export const person = {
  get name(): string {
    return localStorage.getItem('rva-person') ?? '';
  },
  set name(name: string) {
    localStorage.setItem('rva-person', name);
  },
};
