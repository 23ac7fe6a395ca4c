"""What every table of a machine file has in common."""

from typing import Any

from pydantic import BaseModel, ConfigDict


class WrongKey(Exception):
    """What was asked for is a key that is wrong, as is said elsewhere."""


class Table(BaseModel):
    """A table of the machine file: nothing but its own keys, never changed after reading.

    Where the file is wrong a table may lack fields; to ask for one of them raises WrongKey.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", str_strip_whitespace=True)

    def __getattr__(self, name: str) -> Any:
        """Of fields that are not there; all else is found without this."""
        if name in type(self).model_fields:
            raise WrongKey(name)
        return super().__getattr__(name)  # type: ignore[misc]
