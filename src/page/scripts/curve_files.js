/// Every curve and every table as a file.

import {data} from "./data.js";
import {element} from "./elements.js";
import {csvOf, csvOfTable, fileName, save} from "./files.js";
import {quantities} from "./names.js";

/// Links to each curve and each table as a file.
export function listFiles(curves) {
  const list = document.getElementById("curve-files");
  for (const quantity of quantities) {
    for (const curve of curves.filter((one) => one.quantity === quantity.name)) {
      const name = `${quantity.name}, ${curve.label}`;
      list.append(element("li", {}, element("a", {href: "#curves", onclick: (event) => {
        event.preventDefault();
        save(fileName(name, "csv"), csvOf([curve], quantity), "text/csv");
      }}, name)));
    }
  }
  for (const name of Object.keys(data.tables)) {
    list.append(element("li", {}, element("a", {href: "#curves", onclick: (event) => {
      event.preventDefault();
      save(name, csvOfTable(data.tables[name]), "text/csv");
    }}, `all of ${name}`)));
  }
}
