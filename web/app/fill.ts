/** Puts a value into a field that takes it; any other value changes nothing. */
export function fill(field: HTMLInputElement, value: string): void {
  const before = field.value;
  field.value = value;
  if (!field.validity.valid || field.value !== value) field.value = before;
}
