// Where one looks from, and how a finger, a mouse or keys move that.

/** A column-major matrix of four by four. */
export type Matrix = Float32Array;

/** Angles in degrees, and how much of the space is seen. */
export class Camera {
  azimuth = -60;
  elevation = 25;
  zoom = 1;
  pan: [number, number] = [0, 0];

  /** Looks at everything from these angles. */
  home(angles: [number, number] | null): void {
    [this.azimuth, this.elevation] = angles ?? [-60, 25];
    this.zoom = 1;
    this.pan = [0, 0];
  }

  turn(azimuth: number, elevation: number): void {
    this.azimuth = (this.azimuth + azimuth) % 360;
    this.elevation = Math.max(-90, Math.min(90, this.elevation + elevation));
  }

  scale(factor: number): void {
    this.zoom = Math.max(0.2, Math.min(20, this.zoom * factor));
  }

  /** The rows of the rotation: to the right, up, towards the viewer. */
  axes(): [Vector, Vector, Vector] {
    const [a, e] = [this.azimuth, this.elevation].map((angle) => (angle * Math.PI) / 180) as [number, number];
    const [sa, ca, se, ce] = [Math.sin(a), Math.cos(a), Math.sin(e), Math.cos(e)];
    return [
      [-sa, ca, 0],
      [-se * ca, -se * sa, ce],
      [ce * ca, ce * sa, se],
    ];
  }

  /** Zooms so far that a box about the centre, of these half sides, fills what is seen from here. */
  fit(half: Vector, radius: number, width: number, height: number): void {
    const [right, up] = this.axes();
    const reach = (axis: Vector) => axis.reduce((sum, part, k) => sum + Math.abs(part) * (half[k] ?? 0), 0);
    const [wide, tall] = shares(width, height);
    this.zoom = (0.94 * radius) / Math.max(reach(right) * wide, reach(up) * tall, 1e-9 * radius);
  }

  /** From space to the screen, at zoom 1 a ball about `centre` filling the smaller side; without perspective, as drawings are. */
  matrix(centre: Vector, radius: number, width: number, height: number): Matrix {
    const scale = this.zoom / radius;
    const [wide, tall] = shares(width, height);
    const [right, up, towards] = this.axes();
    const rows = [
      { axis: right, by: scale * wide, shift: this.pan[0] },
      { axis: up, by: scale * tall, shift: this.pan[1] },
      { axis: towards, by: -0.3 / radius, shift: 0 },
    ];
    const matrix = new Float32Array(16);
    rows.forEach(({ axis, by, shift }, row) => {
      for (let k = 0; k < 3; k++) matrix[4 * k + row] = by * (axis[k] ?? 0);
      matrix[12 + row] = shift - by * dot(axis, centre);
    });
    matrix[15] = 1;
    return matrix;
  }
}

export type Vector = [number, number, number];

/** How much of a unit fits each way when the smaller side is one. */
function shares(width: number, height: number): [number, number] {
  return [width > height ? height / width : 1, height > width ? width / height : 1];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Lets pointers, the wheel and keys move a camera over an element. */
export function moveCamera(element: HTMLElement, camera: Camera, redraw: () => void, home: () => void): void {
  const pointers = new Map<number, [number, number]>();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  const gone = (event: PointerEvent) => pointers.delete(event.pointerId);
  element.addEventListener("pointerup", gone);
  element.addEventListener("pointercancel", gone);
  element.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const apart = spread();
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
    if (pointers.size > 1) {
      if (apart > 0) camera.scale(spread() / apart);
    } else if (event.shiftKey || event.buttons === 4) {
      camera.pan[0] += (2 * dx) / element.clientWidth;
      camera.pan[1] -= (2 * dy) / element.clientHeight;
    } else {
      camera.turn(-0.4 * dx, 0.4 * dy);
    }
    redraw();
  });
  element.addEventListener(
    "wheel",
    (event) => {
      // The page scrolls under a wheel; with Ctrl, or where the view has the focus, it zooms.
      if (!event.ctrlKey && document.activeElement !== element) return;
      event.preventDefault();
      camera.scale(Math.exp(-0.0015 * event.deltaY));
      redraw();
    },
    { passive: false },
  );
  const keys: Record<string, () => void> = {
    ArrowLeft: () => camera.turn(-5, 0),
    ArrowRight: () => camera.turn(5, 0),
    ArrowUp: () => camera.turn(0, 5),
    ArrowDown: () => camera.turn(0, -5),
    "+": () => camera.scale(1.15),
    "=": () => camera.scale(1.15),
    "-": () => camera.scale(1 / 1.15),
    Home: home,
  };
  element.addEventListener("keydown", (event) => {
    const move = keys[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    move();
    redraw();
  });
}
