/// Elements of the page, and the controls that several sections share.

/// Makes an element with attributes and children. An attribute whose name begins with "on" is a listener.
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name in made) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

/// A row of switches. `options` is a list of [value, label], `chosen` the set of values that are on, which the switches
/// change; `changed` is called afterwards.
export function chips(title, options, chosen, changed) {
  const made = options.map(([value, label]) => {
    const box = element("input", {type: "checkbox", checked: chosen.has(value), onchange: () => {
      if (box.checked) chosen.add(value);
      else chosen.delete(value);
      changed();
    }});
    box.dataset.choice = value;
    return element("label", {className: "chip"}, box, element("span", {}, label));
  });
  return element("fieldset", {}, element("span", {}, title), ...made);
}

/// A drop-down list. `options` is a list of [value, text]; `changed` is called with the value that is chosen.
export function chooser(id, label, options, changed) {
  const select = element("select", {id, ariaLabel: label, onchange: () => changed(options[select.selectedIndex][0])},
    ...options.map(([, text]) => element("option", {}, text)));
  return select;
}
