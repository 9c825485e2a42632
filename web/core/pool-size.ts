/** A job has few tasks at a time, and every worker has an engine with its own memory. */
const mostByDefault = 4;

/** Workers that a device with this little memory bears, and how little, in GiB. */
const [mostOnSmall, smallMemory] = [2, 4];

/** Workers by default: one per core, but few, and fewer where memory is known to be short. */
export function poolSize(cores: number, gibibytes = Infinity): number {
  const most = gibibytes <= smallMemory ? mostOnSmall : mostByDefault;
  return Math.max(1, Math.min(cores, most));
}
