// Numbers: columns unpacked, looked up between samples, and written as the rest of the report writes them.

/** A packed column as numbers, NaN where there is none. */
function unpacked([low, step, codes], count, wide) {
  if (codes === "") return new Float64Array(count).fill(low);
  const bytes = Uint8Array.from(atob(codes), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const size = wide ? 4 : 2;
  const nothing = 2 ** (8 * size) - 1;
  return Float64Array.from({ length: count }, (_, i) => {
    const code = wide ? view.getUint32(4 * i, true) : view.getUint16(2 * i, true);
    return code === nothing ? NaN : low + step * code;
  });
}

const WIDE = new Set(["t", "x", "y", "s"]);

/** A vehicle of a run with its columns unpacked: `columns` by name, and those of its panels. */
function unpackedVehicle(vehicle) {
  const get = (place, wide) => (place === null ? null : unpacked(vehicle.pool[place], vehicle.samples, wide));
  const columns = {};
  for (const [name, place] of Object.entries(vehicle.columns)) columns[name] = get(place, WIDE.has(name));
  const panels = vehicle.panels.map((panel) => {
    const series = {};
    for (const key of ["values", "command", "lower", "upper", "needed"]) series[key] = get(panel[key], false);
    return { ...panel, ...series };
  });
  return { ...vehicle, columns, panels, clock: columns.t.map((t) => t + vehicle.departure) };
}

/** The place of `value` in rising `values`: the sample before it, and the share of the way to the next. */
function located(values, value) {
  let low = 0;
  let high = values.length - 1;
  if (!(value > values[0])) return [0, 0];
  if (value >= values[high]) return [high, 0];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle;
    else high = middle;
  }
  return [low, (value - values[low]) / (values[high] - values[low])];
}

function between(column, [i, share]) {
  return share === 0 ? column[i] : column[i] + share * (column[i + 1] - column[i]);
}

/** An angle [deg] between two samples, the short way round. */
function angleBetween(column, [i, share]) {
  if (share === 0) return column[i];
  const turn = ((((column[i + 1] - column[i] + 180) % 360) + 360) % 360) - 180;
  return column[i] + share * turn;
}

/** A number with so many significant digits, whole digits kept, without trailing zeros. */
function digits(value, count = 3) {
  if (!Number.isFinite(value)) return "n/a";
  if (value === 0) return "0";
  const decimals = Math.max(0, Math.min(count + 3, count - 1 - Math.floor(Math.log10(Math.abs(value)))));
  let shown = value.toFixed(decimals);
  if (shown.includes(".")) shown = shown.replace(/0+$/, "").replace(/\.$/, "");
  return Number(shown) === 0 ? "0" : shown.replace("-", "−");
}

/** A number with fixed decimals, for readouts that change: no jumping width. */
function steady(value, decimals) {
  if (!Number.isFinite(value)) return "n/a";
  const shown = value.toFixed(decimals);
  return Number(shown) === 0 ? shown.replace("-", "") : shown.replace("-", "−");
}

function metres(value) {
  return Math.abs(value) >= 1000 ? `${digits(value / 1000, 4)} km` : `${digits(value)} m`;
}

/** plotly reads a few tags and entities in its texts: a name stays a name. */
function plain(text) {
  return String(text).replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");
}
