// Undo and redo of values that do not change.

/** States one after the other; changes of one kind that follow closely are one step. */
export class Steps<T> {
  private past: T[] = [];
  private future: T[] = [];
  private lastKind = "";
  private lastTime = 0;

  /** `same` tells whether a state is worth a step. */
  constructor(
    private present: T,
    private readonly same: (a: T, b: T) => boolean,
  ) {}

  /** The state that holds. */
  get now(): T {
    return this.present;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** Goes on to a state. A change of the same kind within a second replaces the last one, and so does one of the same drag. */
  go(state: T, kind: string, time: number): void {
    if (this.same(state, this.present)) return;
    const goesOn = kind !== "" && kind === this.lastKind && (kind.startsWith("drag ") || time - this.lastTime < 1000);
    if (!goesOn) this.past.push(this.present);
    if (this.past.length > MAX_STEPS) this.past.shift();
    this.present = state;
    this.future = [];
    this.lastKind = kind;
    this.lastTime = time;
  }

  /** Begins with a state, behind which nothing goes. */
  begin(state: T): void {
    this.present = state;
    this.past = [];
    this.future = [];
    this.lastKind = "";
  }

  undo(): T {
    const before = this.past.pop();
    if (before !== undefined) {
      this.future.push(this.present);
      this.present = before;
    }
    this.lastKind = "";
    return this.present;
  }

  redo(): T {
    const after = this.future.pop();
    if (after !== undefined) {
      this.past.push(this.present);
      this.present = after;
    }
    this.lastKind = "";
    return this.present;
  }
}

/** The most steps back. */
const MAX_STEPS = 500;
