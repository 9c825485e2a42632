/** A binary heap of collapses `{u, v, plan}`, cheapest first; ties go by vertex number, so runs repeat exactly. */
export class Heap {
  items = [];

  static before(a, b) {
    return a.plan.cost - b.plan.cost || a.u - b.u || a.v - b.v;
  }

  push(item) {
    const { items } = this;
    let i = items.push(item) - 1;
    while (i > 0) {
      const parent = (i - 1) >> 1;
      if (Heap.before(items[parent], items[i]) <= 0) break;
      [items[parent], items[i]] = [items[i], items[parent]];
      i = parent;
    }
  }

  pop() {
    const { items } = this;
    const top = items[0];
    const last = items.pop();
    if (items.length === 0) return top;
    items[0] = last;
    for (let i = 0; ;) {
      let least = i;
      for (const child of [2 * i + 1, 2 * i + 2]) {
        if (child < items.length && Heap.before(items[child], items[least]) < 0) least = child;
      }
      if (least === i) return top;
      [items[least], items[i]] = [items[i], items[least]];
      i = least;
    }
  }
}
