// Accessibility basics of a page, from its computed styles. Contrast as WCAG 2.1, 1.4.3: 4.5, of large text 3.
"use strict";

function channels(colour) {
  const numbers = colour.match(/[\d.]+/g).map(Number);
  return { rgb: numbers.slice(0, 3), alpha: numbers.length > 3 ? numbers[3] : 1 };
}

function over(top, alpha, below) { return top.map((value, i) => alpha * value + (1 - alpha) * below[i]); }

function backgroundOf(element) {
  const layers = [];
  for (let e = element; e; e = e.parentElement) layers.push(channels(getComputedStyle(e).backgroundColor));
  return layers.reverse().reduce((below, layer) => over(layer.rgb, layer.alpha, below), [255, 255, 255]);
}

function luminance(rgb) {
  const [r, g, b] = rgb.map((v) => v / 255).map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(a, b) {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

function shown(element) { return element.checkVisibility() && element.getClientRects().length > 0; }

function textFaults() {
  const faults = new Set();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement, text = walker.currentNode.textContent.trim();
    if (!text || ["SCRIPT", "STYLE", "NOSCRIPT"].includes(element.tagName) || !shown(element)) continue;
    const style = getComputedStyle(element), below = backgroundOf(element);
    const top = channels(element instanceof SVGElement ? style.fill : style.color);
    const size = parseFloat(style.fontSize), large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    const ratio = contrast(over(top.rgb, top.alpha, below), below);
    if (ratio < (large ? 3 : 4.5)) faults.add(`contrast ${ratio.toFixed(2)} of "${text.slice(0, 40)}" in ${element.tagName}`);
    if (size < 9) faults.add(`text of ${size} px: "${text.slice(0, 40)}"`);
  }
  return [...faults];
}

function pictureFaults() {
  const faults = [];
  for (const image of document.images) {
    const source = image.getAttribute("src").slice(0, 60);
    if (image.alt.trim().length < 15) faults.push(`alternative text "${image.alt}" of ${source}`);
    if (image.complete && image.naturalWidth === 0) faults.push(`no picture at ${source}`);
  }
  for (const svg of document.querySelectorAll("svg"))
    if (svg.getAttribute("role") !== "img" || !svg.getAttribute("aria-label")) faults.push("a drawing without name");
  return faults;
}

function headingFaults() {
  const levels = [...document.querySelectorAll("h1, h2, h3, h4, h5, h6")].map((h) => Number(h.tagName[1]));
  const faults = levels[0] === 1 && levels.filter((level) => level === 1).length === 1 ? [] : ["not one h1, first"];
  for (let i = 1; i < levels.length; ++i)
    if (levels[i] > levels[i - 1] + 1) faults.push(`h${levels[i]} after h${levels[i - 1]}`);
  return faults;
}

function nameOf(control) {
  const labels = [...(control.labels || [])].map((label) => label.textContent).join(" ");
  return (control.getAttribute("aria-label") || labels || control.textContent).trim();
}

function controlFaults() {
  const controls = [...document.querySelectorAll("a[href], button, input, select, textarea")];
  const empty = controls.filter((c) => !nameOf(c) && !c.querySelector("img[alt]"));
  const faults = empty.map((c) => `a ${c.tagName} without name`);
  for (const table of document.querySelectorAll("table"))
    if (!table.querySelector("th[scope]")) faults.push("a table without heading cells");
  const ids = [...document.querySelectorAll("[id]")].map((e) => e.id);
  if (new Set(ids).size !== ids.length) faults.push("an id twice");
  if (!document.documentElement.lang || !document.title) faults.push("no language or title");
  return faults;
}

function audit() { return [...textFaults(), ...pictureFaults(), ...headingFaults(), ...controlFaults()]; }

function scrolls(element) {
  for (let e = element; e; e = e.parentElement)
    if (e !== document.documentElement && ["auto", "scroll", "hidden"].includes(getComputedStyle(e).overflowX)) return true;
  return false;
}

function overflow() {
  const width = document.documentElement.clientWidth, found = [];
  for (const element of document.body.querySelectorAll("*")) {
    if (!shown(element) || element instanceof SVGElement || scrolls(element.parentElement)) continue;
    const right = element.getBoundingClientRect().right;
    if (right > width + 1) found.push(`${element.tagName}.${element.className} ends at ${right.toFixed(0)} of ${width}: ` +
      `"${element.textContent.trim().slice(0, 40)}"`);
  }
  if (document.documentElement.scrollWidth > width + 1) found.push(`the page is ${document.documentElement.scrollWidth} wide of ${width}`);
  return found;
}
