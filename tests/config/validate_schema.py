#!/usr/bin/python3
"""validate_schema.py SCHEMA <LIST: what a JSON Schema validator says of the YAML files that the list names, one a line:
"accepted NAME", "refused NAME PATH: MESSAGE" or "no-yaml NAME MESSAGE". Exit status 77 without python3-jsonschema or
python3-yaml."""
import json
import os
import re
import sys

try:
    import jsonschema
    import yaml
except ImportError:
    sys.exit(77)


class Loader(yaml.SafeLoader):
    """YAML 1.2's core schema, as editors read it: `on` is a word and each key stands once."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in (
    ("bool", r"^(true|True|TRUE|false|False|FALSE)$", "tTfF"),
    ("null", r"^(~|null|Null|NULL|)$", ["~", "n", "N", ""]),
    ("int", r"^[-+]?[0-9]+$", "-+0123456789"),
    ("float", r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$", "-+.0123456789"),
    ("float", r"^([-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN))$", "-+."),
):
    Loader.add_implicit_resolver("tag:yaml.org,2002:" + tag, re.compile(pattern), list(first))
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(loader.construct_scalar(node), 10))


def construct_once(loader, node, deep=False):
    keys = [key.value for key, _ in node.value]
    if any(not isinstance(key, str) for key in keys):
        raise yaml.constructor.ConstructorError(None, None, "a key that is no word", node.start_mark)
    if len(set(keys)) != len(keys):
        raise yaml.constructor.ConstructorError(None, None, "a key stands twice", node.start_mark)
    return {key.value: loader.construct_object(value, deep=True) for key, value in node.value}


Loader.add_constructor("tag:yaml.org,2002:map", construct_once)


def judge(validator, path):
    name = os.path.basename(path)
    try:
        with open(path, encoding="utf-8") as file:
            value = yaml.load(file, Loader)
        # A value that holds itself has no end, and one of many aliases hardly one.
        if len(json.dumps(value)) > 1 << 22:
            return f"no-yaml {name} too large"
    except (yaml.YAMLError, UnicodeDecodeError, RecursionError, ValueError) as error:
        return f"no-yaml {name} {' '.join(str(error).split())[:120]}"
    error = jsonschema.exceptions.best_match(validator.iter_errors(value))
    if error is None:
        return f"accepted {name}"
    return f"refused {name} {'.'.join(map(str, error.absolute_path))}: {error.message[:120]}"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    for path in sys.stdin.read().splitlines():
        print(judge(validator, path))


main()
