"""Runs the code cells of a notebook, one after the other, as a kernel would: by nbconvert where it is installed.

A cell that says raises-exception in its tags must raise.   usage: run_notebook.py NOTEBOOK
"""

import ast
import importlib.util
import json
import pathlib
import sys


def run_cells(notebook):
    """Runs them in this process; of each, what its last line is, is asked for its picture or text, as it is shown."""
    names = {"__name__": "__main__"}
    for number, cell in enumerate(notebook["cells"], 1):
        if cell["cell_type"] != "code":
            continue
        must_raise = "raises-exception" in cell["metadata"].get("tags", [])
        tree = ast.parse("".join(cell["source"]), f"cell {number}")
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        try:
            exec(compile(tree, f"cell {number}", "exec"), names)
            if last:
                shown = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names)
                assert getattr(shown, "_repr_png_", lambda: b"\x89PNG")().startswith(b"\x89PNG")
        except Exception as error:
            if not must_raise:
                raise
            print(f"cell {number} shows {error}")
        else:
            assert not must_raise, f"cell {number} shows no mistake"


def run_by_nbconvert(path):
    import nbformat
    from nbconvert.preprocessors import ExecutePreprocessor

    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    execution = ExecutePreprocessor(timeout=120, kernel_name="python3")
    execution.preprocess(notebook, {"metadata": {"path": str(path.parent)}})
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    pictures = sum("image/png" in output.get("data", {}) for output in outputs)
    print(f"nbconvert: {len(notebook.cells)} cells, {pictures} pictures shown")


def main():
    path = pathlib.Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(path.parent))
    if all(importlib.util.find_spec(name) for name in ("nbconvert", "nbformat", "ipykernel")):
        run_by_nbconvert(path)
    else:
        run_cells(json.loads(path.read_text(encoding="utf-8")))


main()
