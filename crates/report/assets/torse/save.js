// Files of what is seen: a drawing of both views in SVG, the pattern in true size in DXF.
const save = (() => {
  const give = (name, type, text) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };

  const svg = (title, panes) => {
    const width = panes.reduce((sum, pane) => sum + pane.width, 0), height = Math.max(...panes.map((pane) => pane.height));
    let left = 0;
    const groups = panes.map((pane) => {
      const group = `<g transform="translate(${left} 0)">${pane.drawn()}</g>`;
      left += pane.width;
      return group;
    });
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">
<title>${title.replace(/&/g, "&amp;").replace(/</g, "&lt;")}</title>
<rect width="100%" height="100%" fill="#fff"/>
${groups.join("\n")}
</svg>
`;
  };

  // DXF of AutoCAD R12, which every program reads: polylines and lines on named layers, each entity a list of coded values.
  const LAYERS = { OUTLINE: 7, RULINGS: 8, REGRESSION: 6 };
  function dxf(pieces) {
    const out = [];
    const put = (...pairs) => { for (let k = 0; k < pairs.length; k += 2) out.push(pairs[k], pairs[k + 1]); };
    const number = (value) => value.toFixed(6);
    const polyline = (layer, points, closed) => {
      put(0, "POLYLINE", 8, layer, 66, 1, 70, closed ? 1 : 0);
      for (const [x, y] of points) put(0, "VERTEX", 8, layer, 10, number(x), 20, number(y), 30, "0.0");
      put(0, "SEQEND");
    };
    put(0, "SECTION", 2, "HEADER", 9, "$ACADVER", 1, "AC1009", 0, "ENDSEC", 0, "SECTION", 2, "TABLES");
    put(0, "TABLE", 2, "LAYER", 70, Object.keys(LAYERS).length);
    for (const [layer, colour] of Object.entries(LAYERS)) put(0, "LAYER", 2, layer, 70, 0, 62, colour, 6, "CONTINUOUS");
    put(0, "ENDTAB", 0, "ENDSEC", 0, "SECTION", 2, "ENTITIES");
    for (const { stations, shown, summit } of pieces) {
      const rail = (end) => stations.map((one) => develop.flat(one, one.spans[end]));
      polyline("OUTLINE", [...rail(0), ...rail(1).reverse()], true);
      stations.forEach((one, k) => {
        if (k % 6 || !k || k === stations.length - 1) return;
        const [[x, y], [u, v]] = one.spans.map((span) => develop.flat(one, span));
        put(0, "LINE", 8, "RULINGS", 10, number(x), 20, number(y), 30, "0.0", 11, number(u), 21, number(v), 31, "0.0");
      });
      if (shown.length > 1 && !summit) polyline("REGRESSION", shown.map((one) => develop.flat(one, one.reach)), false);
    }
    put(0, "ENDSEC", 0, "EOF");
    return out.join("\n") + "\n";
  }

  return { give, svg, dxf };
})();
