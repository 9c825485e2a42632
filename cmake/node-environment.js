// Emscripten starts programs with an invented environment; tests and benchmarks read the real one.
Module['preRun'] = () => Object.assign(ENV, process.env);
