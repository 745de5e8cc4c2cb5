"""The embedded reader: prompt to programme in several languages, without a language model."""

from apartgen.stages.plan.reader.program import bounded, complete_program, read

__all__ = ["bounded", "complete_program", "read"]
