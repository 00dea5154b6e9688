"""Sound files for tests."""

from __future__ import annotations

import wave
from pathlib import Path


def write_sound(file: Path, seconds: float) -> None:
    """Writes a square wave of 500 Hz, mono, as WAV."""
    with wave.open(str(file), "wb") as sound:
        sound.setnchannels(1)
        sound.setsampwidth(2)
        sound.setframerate(8000)
        period = b"\x00\x20" * 8 + b"\x00\xe0" * 8
        sound.writeframes(period * round(seconds * 500))
