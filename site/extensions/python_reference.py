"""The reference of Python is made of the docstrings of the module that was built; what it shows are public names."""

import os
import re
import sys


def public_names(app, what, name, obj, options, signature, returns):
    def public(text):
        return text and re.sub(r"\bbreccia\._[a-z]+\.", "breccia.", text)

    return public(signature), public(returns)


def setup(app):
    sys.path.insert(0, os.environ["BRECCIA_PYTHON"])
    app.connect("autodoc-process-signature", public_names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
