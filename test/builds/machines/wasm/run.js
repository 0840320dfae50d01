// run.js - run a program compiled for wasm32 by node: its C library is what
// stands here, all that tess asks for.  See ../reach.sh.
//
//     node test/builds/machines/wasm/run.js tiny.wasm
const fs = require("fs");
let memory, text = "";

// parts - x = part * 2 ** exponent, 0.5 <= |part| < 1, by the number's bits;
// those of a subnormal one are shifted first.
function parts(x) {
  if (x === 0 || !Number.isFinite(x)) return [x, 0];
  const bits = new DataView(new ArrayBuffer(8));
  const small = Math.abs(x) < 2 ** -1022;
  bits.setFloat64(0, small ? x * 2 ** 64 : x);
  const high = bits.getUint32(0);
  bits.setUint32(0, ((high & 0x800fffff) | 0x3fe00000) >>> 0);
  return [bits.getFloat64(0), ((high >>> 20) & 2047) - (small ? 1086 : 1022)];
}

const env = {
  fabs: Math.abs,
  sqrt: Math.sqrt,
  frexp: (x, to) => {
    const [part, exponent] = parts(x);
    new DataView(memory.buffer).setInt32(to, exponent, true);
    return part;
  },
  ldexp: (x, by) => { // (one rounding)
    const [part, exponent] = parts(x);
    by = Math.max(exponent + by, -1075);
    return by < -1074 ? 0 * part : part * 2 * 2 ** Math.min(by - 1, 1024);
  },
  memcpy: (to, from, many) => {
    new Uint8Array(memory.buffer).copyWithin(to, from, from + many);
    return to;
  },
  memset: (to, value, many) => {
    new Uint8Array(memory.buffer).fill(value, to, to + many);
    return to;
  },
  put: (c) => { text += String.fromCharCode(c); },
};
WebAssembly.instantiate(fs.readFileSync(process.argv[2]), { env })
  .then(({ instance }) => {
    memory = instance.exports.memory;
    const code = instance.exports.main(0, 0);
    process.stdout.write(text, () => process.exit(code));
  });
