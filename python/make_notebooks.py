"""Makes notebooks of examples, whose cells begin with `# %%`, and executes them."""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient


def cells_of(text):
    """The cells of an example: pairs of whether a cell is text, and its content."""
    for part in text.split("# %%")[1:]:
        heading, _, body = part.partition("\n")
        if "[markdown]" in heading:
            yield True, "\n".join(line[2:] for line in body.strip().splitlines())
        else:
            yield False, body.strip()


def notebook_of(text):
    notebook = nbformat.v4.new_notebook()
    make = {True: nbformat.v4.new_markdown_cell, False: nbformat.v4.new_code_cell}
    notebook.cells = [make[is_text](content) for is_text, content in cells_of(text)]
    for number, cell in enumerate(notebook.cells):
        cell["id"] = f"cell-{number}"
    notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return notebook


def main(examples):
    for example in map(Path, examples):
        notebook = notebook_of(example.read_text())
        NotebookClient(notebook, timeout=600, record_timing=False,
                       resources={"metadata": {"path": str(example.parent)}}).execute()
        nbformat.write(notebook, example.with_suffix(".ipynb"))
        print(example.with_suffix(".ipynb"))


if __name__ == "__main__":
    main(sys.argv[1:])
