/// Brings the children of an element into line with what there is to show, without touching those that stay, so that
/// nothing flickers and what has the focus keeps it.

const childrenOf = new WeakMap();

/// `wanted` lists the parts in their order: {id, kind, make, value}. A part that is there with the same id and kind is
/// updated with its value; make() makes a new one, as {element, update(value)}. A part of another kind takes its place,
/// unless the user is typing into it.
export function reconcile(parent, wanted) {
  if (!childrenOf.has(parent)) childrenOf.set(parent, new Map());
  const parts = childrenOf.get(parent);
  const ids = new Set(wanted.map(({id}) => id));
  for (const [id, part] of parts) {
    if (ids.has(id)) continue;
    part.element.remove();
    parts.delete(id);
  }
  let next = parent.firstChild;
  for (const {id, kind, make, value} of wanted) {
    let part = parts.get(id);
    if (part === undefined || (part.kind !== kind && !isTyping(part.element))) {
      const made = {...make(), kind};
      if (part !== undefined) {
        if (next === part.element) next = next.nextSibling;
        part.element.remove();
      }
      part = made;
      parts.set(id, part);
    }
    if (part.element === next) next = next.nextSibling;
    else parent.insertBefore(part.element, next);
    part.update(value);
  }
}

/// Whether the user is typing into a field of an element.
export function isTyping(element) {
  const active = document.activeElement;
  return active !== null && element.contains(active) && active.matches("textarea, input:not([type=checkbox])");
}

/// Calls change(), and gives the focus back to the control that has taken the place of the one that had it. Controls are
/// told apart by the path in their data-focus; `pathNow(path)` is the path that it has after the change.
export function keepingFocus(change, pathNow = (path) => path) {
  const active = document.activeElement;
  const name = active?.dataset?.focus;
  change();
  if (name === undefined || document.contains(active)) return;
  const now = JSON.stringify(pathNow(JSON.parse(name)));
  document.querySelector(`[data-focus="${CSS.escape(now)}"]`)?.focus();
}
