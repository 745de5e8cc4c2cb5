"""The one place where a language model is called. litellm is imported when a model is asked, not before."""

import logging
import os
import re
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

from apartgen.schemas.errors import ApartgenError, BadInput, Unmet
from apartgen.stages.plan.llm.bounded import cause, client

log = logging.getLogger("apartgen")

Messages = list[dict[str, str]]


@dataclass(frozen=True)
class Answer:
    """One reply. `refusal` is what servers put beside the text; `cut_off` that the length limit was hit."""

    text: str
    refusal: str = ""
    cut_off: bool = False
    prompt_tokens: int = 0
    completion_tokens: int = 0
    cost: float | None = None


class Model:
    """A model under its litellm name. Remembers which way of asking for JSON its server takes."""

    def __init__(self, name: str, timeout: float, retries: int, backoff: float, api_base: str | None) -> None:
        self.name = name
        self.timeout = timeout
        self.retries = retries
        self.backoff = backoff
        self.api_base = api_base
        self.way = 0
        self.litellm = _litellm()
        _check_name(self.litellm, name)

    def complete(self, messages: Messages, schema: dict[str, Any]) -> Answer:
        """Ask once, by JSON schema if the server takes it, else by plainer means; asks again when it is busy."""
        ways = _ways(schema)
        for way in range(self.way, len(ways)):
            try:
                answer = self._patiently(messages, ways[way])
            except self.litellm.ContentPolicyViolationError as e:
                return Answer("", refusal=_reason(e))
            except (self.litellm.BadRequestError, self.litellm.UnprocessableEntityError) as e:
                if way + 1 == len(ways) or isinstance(e, self.litellm.ContextWindowExceededError):
                    raise BadInput(f"{self.name} rejected the request: {_reason(e)}") from e
                continue
            self.way = way
            return answer
        raise AssertionError("unreachable: the last way returns or raises")

    def _patiently(self, messages: Messages, way: dict[str, Any]) -> Answer:
        last: Exception | None = None
        for attempt in range(self.retries + 1):
            if attempt:
                time.sleep(self.backoff * 2 ** (attempt - 1))
            try:
                return self._once(messages, way)
            except self._busy() as e:
                last = e
                log.info("%s: %s; attempt %d of %d", self.name, type(e).__name__, attempt + 1, self.retries + 1)
            except (self.litellm.BadRequestError, self.litellm.UnprocessableEntityError):
                raise
            except Exception as e:
                raise self._final(e) from e
        assert last is not None
        raise self._final(last) from last

    def _once(self, messages: Messages, way: dict[str, Any]) -> Answer:
        extra = {"api_base": self.api_base} if self.api_base else {}
        reply = self._in_time(
            lambda: self.litellm.completion(
                model=self.name,
                messages=messages,
                temperature=0,
                timeout=self.timeout,
                max_retries=0,
                num_retries=0,
                **extra,
                **way,
            )
        )
        if not reply.choices:
            return Answer("")
        choice = reply.choices[0]
        usage = getattr(reply, "usage", None)
        return Answer(
            text=choice.message.content or "",
            refusal=getattr(choice.message, "refusal", None)
            or (choice.message.provider_specific_fields or {}).get("refusal")
            or "",
            cut_off=choice.finish_reason == "length",
            prompt_tokens=getattr(usage, "prompt_tokens", 0) or 0,
            completion_tokens=getattr(usage, "completion_tokens", 0) or 0,
            cost=self._cost(reply),
        )

    def _in_time(self, ask: Callable[[], Any]) -> Any:
        """The reply, all of it within the time limit: the client's own limit is between one byte and the next."""
        found: Future[Any] = Future()

        def run() -> None:
            try:
                found.set_result(ask())
            except BaseException as error:
                found.set_exception(error)

        threading.Thread(target=run, daemon=True).start()
        try:
            return found.result(self.timeout)
        except TimeoutError:
            raise self.litellm.Timeout("the reply did not end", model=self.name, llm_provider="") from None

    def _cost(self, reply: Any) -> float | None:
        try:
            return float(self.litellm.completion_cost(completion_response=reply, model=self.name))
        except Exception:  # litellm raises bare Exception for models without a price
            return None

    def _busy(self) -> tuple[type[Exception], ...]:
        names = (
            "RateLimitError",
            "Timeout",
            "APIConnectionError",
            "InternalServerError",
            "ServiceUnavailableError",
            "BadGatewayError",
        )
        return tuple(getattr(self.litellm, n) for n in names if hasattr(self.litellm, n))

    def _final(self, e: Exception) -> ApartgenError:
        """A litellm error in our words; nothing of a key survives."""
        if isinstance(e, (self.litellm.AuthenticationError, self.litellm.PermissionDeniedError)):
            return BadInput(f"{self.name} refused the key: {_reason(e)}; set the provider's key in the environment")
        if isinstance(e, self.litellm.NotFoundError):
            return BadInput(f"there is no model {self.name}: {_reason(e)}")
        if isinstance(e, self.litellm.Timeout):
            asked = f"asked {self.retries + 1} times"
            return Unmet(
                f"{self.name} gave no answer within {self.timeout:g} s, {asked}; try later, or leave out --llm"
            )
        if fault := cause(e):
            return Unmet(f"{self.name}: {fault}; try another model, or leave out --llm")
        return Unmet(f"{self.name} could not be asked: {type(e).__name__}: {_reason(e)}; try later, or leave out --llm")


def _litellm() -> Any:
    os.environ.setdefault("LITELLM_LOCAL_MODEL_COST_MAP", "True")  # else it fetches a price list on import
    os.environ.setdefault("LITELLM_LOG", "ERROR")
    import litellm

    litellm.telemetry = False
    litellm.suppress_debug_info = True
    litellm.drop_params = True
    litellm.client_session = litellm.client_session or client()
    return litellm


def _check_name(litellm: Any, name: str) -> None:
    """BadInput for a name no provider has, or a provider whose key is not set."""
    try:
        _, provider, _, _ = litellm.get_llm_provider(model=name)
    except Exception as e:
        raise BadInput(
            f"no model is called {name!r}; use provider/model as litellm names them, e.g. openai/gpt-4o-mini"
        ) from e
    missing = litellm.validate_environment(model=name).get("missing_keys") or []
    keys = [k for k in missing if k.endswith(("_KEY", "_TOKEN"))]
    if keys:
        raise BadInput(f"{name} needs {' and '.join(keys)} in the environment (provider {provider})")


def _ways(schema: dict[str, Any]) -> list[dict[str, Any]]:
    """Ways to ask for JSON, the strictest first."""
    named = {"name": "reply", "schema": schema, "strict": False}
    return [
        {"response_format": {"type": "json_schema", "json_schema": named}},
        {"response_format": {"type": "json_object", "schema": schema}},
        {"response_format": {"type": "json_object"}},
        {},
    ]


def _reason(e: Exception) -> str:
    """First line of an error, short, with everything that could be a key blotted out."""
    text = " ".join(str(getattr(e, "message", "") or e).split("\n")[0].split())
    for name, value in os.environ.items():
        if name.endswith(("_KEY", "_TOKEN")) and len(value) >= 4:
            text = text.replace(value, "…")
    text = re.sub(r"\b(?:sk|key|Bearer)[-_ ][\w*.-]{4,}", "…", text)
    return text if len(text) <= 200 else text[:199] + "…"
