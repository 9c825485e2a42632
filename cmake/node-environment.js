// Emscripten starts programs with an invented environment; tests and benchmarks read the real one. A program that
// never asks for its environment has none.
Module['preRun'] = () => typeof ENV === 'object' && Object.assign(ENV, process.env);
