"""The embedded reader: prompt to programme in several languages, without a language model."""

from stages.plan.reader.program import complete_program, read, refuse_absurd

__all__ = ["complete_program", "read", "refuse_absurd"]
