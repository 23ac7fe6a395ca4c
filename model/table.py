"""What every table of a machine file has in common."""

from pydantic import BaseModel, ConfigDict


class Table(BaseModel):
    """A table of the machine file: nothing but its own keys, never changed after reading."""

    model_config = ConfigDict(frozen=True, extra="forbid", str_strip_whitespace=True)
