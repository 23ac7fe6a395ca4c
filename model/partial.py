"""A machine whose file is wrong in places: what is right of it can be asked for, and judged.

Rules between keys ask the machine for what they need. A key that is wrong already raises WrongKey,
and so a rule stays silent about what depends on that key.
"""

from functools import cache
from typing import Annotated, Any, TypeVar, get_origin

from pydantic import BeforeValidator, ConfigDict, TypeAdapter, ValidationError

from turnbuckle.model.problem import Location, field_names, table_in
from turnbuckle.model.table import Table

SomeTable = TypeVar("SomeTable", bound=Table)
PLAIN = ConfigDict(str_strip_whitespace=True)


def partial(schema: type[SomeTable], content: dict[str, Any]) -> SomeTable:
    """The table with what is right of its content; to ask it for another key raises WrongKey."""
    table = schema.model_construct(_fields_set=set())
    for key, name in field_names(schema).items():
        if key in content:
            vars(table).pop(name, None)
            table.model_fields_set.add(name)
            try:
                vars(table)[name] = _value(schema, name, content[key])
            except ValidationError:
                continue
    return table


def _value(schema: type[Table], name: str, content: object) -> object:
    """The value of a field, with what is right of the tables in it; ValidationError for none."""
    field = schema.model_fields[name]
    inner = table_in(field.annotation)
    if inner and get_origin(field.annotation) is not tuple and isinstance(content, dict):
        return partial(inner, content)
    if inner and get_origin(field.annotation) is tuple and _are_tables(content):
        prepared: Any = content
        for item in field.metadata:
            if isinstance(item, BeforeValidator):
                prepared = item.func(prepared)  # type: ignore[call-arg]
        return tuple(partial(inner, entry) for entry in prepared)
    return _reader(schema, name).validate_python(content)


def _are_tables(content: object) -> bool:
    return isinstance(content, list) and all(isinstance(entry, dict) for entry in content)


@cache
def _reader(schema: type[Table], name: str) -> TypeAdapter[Any]:
    field = schema.model_fields[name]
    kind: Any = (
        Annotated[(field.annotation, *field.metadata)] if field.metadata else field.annotation
    )
    return TypeAdapter(kind, config=None if table_in(field.annotation) else PLAIN)


def value_at(table: Table, location: Location) -> Any:
    """What a table holds at a location of keys and numbers; None where a table on the way is None.

    Raises WrongKey for what is wrong already.
    """
    here: Any = table
    for part in location:
        if here is None:
            return None
        here = here[part] if isinstance(part, int) else getattr(here, _field(here, part))
    return here


def _field(table: Table, key: str) -> str:
    return field_names(type(table))[key]


def forget(table: Table, location: Location) -> None:
    """Take what is at a location for wrong: whoever asks for it gets WrongKey from now on."""
    held = vars(table)
    for derived in held.keys() - type(table).model_fields.keys():
        del held[derived]
    if not location:
        held.clear()
        return
    key, *rest = location
    name = field_names(type(table)).get(str(key), "")
    inner = held.get(name)
    if isinstance(inner, tuple) and rest and isinstance(rest[0], int):
        inner, rest = inner[rest[0]] if rest[0] < len(inner) else None, rest[1:]
        if isinstance(inner, Table):
            forget(inner, rest)
            return
    if isinstance(inner, Table) and rest:
        forget(inner, rest)
    else:
        held.pop(name, None)
