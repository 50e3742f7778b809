// Search of the site. Lists the pages and sections that contain all words, those with all words in their title first.
// The index is a script, search_index.js, because a page opened from a local folder cannot load JSON.
"use strict";
(() => {
  const root = document.body.dataset.root.replace(/\/?$/, "/");
  const field = document.getElementById("search"), list = document.getElementById("found");
  const fold = (text) => text.toLowerCase();
  const sections = window.searchIndex.map((s) => ({ ...s, folded: fold(s.title + " " + s.text), name: fold(s.title) }));

  function excerpt(section, word) {
    const at = Math.max(0, fold(section.text).indexOf(word) - 40);
    return (at ? "..." : "") + section.text.slice(at, at + 110);
  }

  function show() {
    const words = fold(field.value).split(/\s+/).filter(Boolean);
    const hits = !words.length ? [] : sections.filter((s) => words.every((w) => s.folded.includes(w)))
      .map((s) => ({ s, score: words.reduce((sum, w) => sum + (s.name === w ? 9 : s.name.includes(w) ? 3 : 0), 0) }))
      .sort((a, b) => b.score - a.score).slice(0, 20);
    list.replaceChildren(...hits.map(({ s }) => {
      const item = document.createElement("li"), link = document.createElement("a"), text = document.createElement("small");
      link.href = root + s.location;
      link.textContent = s.page && s.page !== s.title ? s.page + ": " + s.title : s.title;
      text.textContent = excerpt(s, words[0]);
      item.append(link, text);
      return item;
    }));
    if (words.length && !hits.length) list.textContent = "Nothing found";
    list.hidden = !words.length;
  }

  field.addEventListener("input", show);
  field.addEventListener("keydown", (event) => {
    if (event.key === "Escape") { field.value = ""; show(); }
    if (event.key === "Enter") list.querySelector("a")?.click();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement !== field) { event.preventDefault(); field.focus(); }
  });
  const wanted = new URLSearchParams(location.search).get("q");
  if (wanted) { field.value = wanted; show(); }
  else document.querySelector("nav .here")?.scrollIntoView({ block: "nearest" });
})();
