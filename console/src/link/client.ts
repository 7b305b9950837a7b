// Who this console is: for the server, which keeps the controls for it when the page is loaded again.

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

/** Of this tab. Nobody else knows it. */
export const clientId = remembered('rva-client', randomId);

/** The person who uses this computer, where nobody signs in. */
export const person = {
  get name(): string {
    return localStorage.getItem('rva-person') ?? '';
  },
  set name(name: string) {
    localStorage.setItem('rva-person', name);
  },
};
