// Work that is asked for more often than it can be done.

/** Calls `work` once at a time; of the calls that come meanwhile only the newest is done. */
export function keepNewest(work) {
  let waiting = null, running = null;
  const run = async () => {
    while (waiting) {
      const args = waiting;
      waiting = null;
      try {
        await work(...args);
      } catch (error) {
        if (error.status !== 0 && error.name !== "AbortError") console.warn(error);
      }
    }
    running = null;
  };
  return (...args) => {
    waiting = args;
    running ??= run();
    return running;
  };
}

/** Calls `work` when nobody has asked for it for `wait_ms`. */
export function debounce(work, wait_ms) {
  let timer = 0;
  return (...args) => {
    clearTimeout(timer);
    timer = setTimeout(() => work(...args), wait_ms);
  };
}
