/** Lets the page draw and answer before the work goes on. */
export function nextFrame(): Promise<void> {
  // A frame never comes while the page is in the background; the timer does.
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, 100);
    requestAnimationFrame(() => {
      clearTimeout(timer);
      // After the frame has been drawn, not before it.
      setTimeout(resolve, 0);
    });
  });
}
