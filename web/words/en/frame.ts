/** What a frame says of requests that make no sense: to those who write the page around it, in English alone. */
export const frameFaults = {
  source: 'source: this is neither an address nor a list of files with name and bytes',
  time: 'time: this is no number',
  attribute: (name: string): string => `attributes: there is no '${name}' that can be set`,
  ask: (name: string): string => `ask: there is no '${name}'`,
};
