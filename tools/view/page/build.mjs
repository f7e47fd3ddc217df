// Bundles the page into one HTML text with a content security policy, and writes the text as a C++ file:
//   node build.mjs page.cpp
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";

async function bundle(entry) {
  const result = await build({
    entryPoints: [entry], bundle: true, minify: true, format: "iife", target: "es2022", charset: "utf8",
    legalComments: "inline", write: false,
  });
  return result.outputFiles[0].text;
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** Returns the parts of the page before and after the data. The page allows only its own script and style, and no network requests. */
async function buildPage() {
  const script = await bundle("src/main.ts");
  const style = await bundle("src/style.css");
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; img-src data:; ` +
    "base-uri 'none'; form-action 'none'";
  const parts = { policy: `<meta http-equiv="Content-Security-Policy" content="${policy}">`,
    style: `<style>${style}</style>`, script: `<script>${script}</script>` };
  const html = readFileSync("index.html", "utf8").replace(/<!-- (policy|style|script) -->/g, (_, name) => parts[name]);
  return html.split("<!-- data -->");
}

/** Returns the text as a C++ string literal in several lines. "?" is escaped, because "??" would begin a trigraph. */
function cppLiteral(text) {
  const characters = [...Buffer.from(text)].map((byte) => {
    if (byte === 0x22 || byte === 0x5c) return "\\" + String.fromCharCode(byte);
    return byte >= 0x20 && byte < 0x7f && byte !== 0x3f ? String.fromCharCode(byte) : "\\" + byte.toString(8).padStart(3, "0");
  });
  const lines = [];
  for (let first = 0; first < characters.length; first += 4000) lines.push(`"${characters.slice(first, first + 4000).join("")}"`);
  return lines.join("\n");
}

const [before, after] = await buildPage();
writeFileSync(process.argv[2], `#include "page.hpp"

const beadswim::Page beadswim::page{
${cppLiteral(before)},
${cppLiteral(after)},
""};
`);
