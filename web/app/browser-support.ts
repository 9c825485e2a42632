/** What the engine needs from the browser, tried with the smallest modules that use it. */

// (func (result v128) i32.const 0  i8x16.splat  i8x16.popcnt)
const simdModule = [
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15,
  253, 98, 11,
];
// (func  try  end)
const exceptionsModule = [
  0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11,
];

function accepts(module: number[]): boolean {
  return WebAssembly.validate(new Uint8Array(module));
}

/** Whether workers can be modules: such browsers alone ask which type is wanted. */
function hasModuleWorkers(): boolean {
  let asked = false;
  const options: WorkerOptions = {
    get type() {
      asked = true;
      return 'module' as const;
    },
  };
  try {
    // There is no such script, and so nothing starts.
    new Worker('blob:', options).terminate();
  } catch {
    // Some browsers refuse the address, after they have looked at the options.
  }
  return asked;
}

/** Whether this browser can run the engine. */
export function isSupported(): boolean {
  return (
    typeof WebAssembly === 'object' &&
    typeof Worker === 'function' &&
    hasModuleWorkers() &&
    accepts(simdModule) &&
    accepts(exceptionsModule)
  );
}
