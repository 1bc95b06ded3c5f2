// Two pens with the same strokes: one for a canvas, one that writes SVG. What is drawn once can so be seen and saved.
const pens = (() => {
  const FONT = "12px system-ui, sans-serif";

  function canvasPen(canvas) {
    const density = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = Math.round(width * density);
    canvas.height = Math.round(height * density);
    const pen = canvas.getContext("2d");
    pen.scale(density, density);
    pen.lineJoin = pen.lineCap = "round";
    const path = (points, closed) => {
      pen.beginPath();
      points.forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
      if (closed) pen.closePath();
    };
    return {
      width, height,
      face(points, fill, seam = 0) {
        path(points, true);
        pen.fillStyle = fill;
        pen.fill();
        if (!seam) return;
        pen.strokeStyle = fill;
        pen.lineWidth = seam;
        pen.stroke();
      },
      line(points, colour, thick, dash = []) {
        path(points, false);
        pen.strokeStyle = colour;
        pen.lineWidth = thick;
        pen.setLineDash(dash);
        pen.stroke();
        pen.setLineDash([]);
      },
      dot([x, y], colour, radius) {
        pen.beginPath();
        pen.arc(x, y, radius, 0, 7);
        pen.fillStyle = colour;
        pen.fill();
      },
      text([x, y], words, colour, align = "center") {
        pen.font = FONT;
        pen.fillStyle = colour;
        pen.textAlign = align;
        pen.textBaseline = "middle";
        pen.fillText(words, x, y);
      },
    };
  }

  function svgPen(width, height) {
    const parts = [], near = (value) => Math.round(value * 100) / 100;
    const list = (points) => points.map(([x, y]) => `${near(x)},${near(y)}`).join(" ");
    const escaped = (words) => words.replace(/&/g, "&amp;").replace(/</g, "&lt;");
    return {
      width, height,
      face: (points, fill, seam = 0) => parts.push(`<polygon points="${list(points)}" fill="${fill}"${seam ? ` stroke="${fill}" stroke-width="${seam}" stroke-linejoin="round"` : ""}/>`),
      line: (points, colour, thick, dash = []) => parts.push(`<polyline points="${list(points)}" fill="none" stroke="${colour}" stroke-width="${thick}" stroke-linejoin="round" stroke-linecap="round"${dash.length ? ` stroke-dasharray="${dash.join(" ")}"` : ""}/>`),
      dot: ([x, y], colour, radius) => parts.push(`<circle cx="${near(x)}" cy="${near(y)}" r="${radius}" fill="${colour}"/>`),
      text: ([x, y], words, colour, align = "center") => parts.push(`<text x="${near(x)}" y="${near(y)}" fill="${colour}" text-anchor="${{ center: "middle", left: "start", right: "end" }[align]}" dominant-baseline="central">${escaped(words)}</text>`),
      drawn: () => `<g font-family="system-ui, sans-serif" font-size="12">${parts.join("\n")}</g>`,
    };
  }

  return { canvasPen, svgPen };
})();
