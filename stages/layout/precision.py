"""Whether to compute in bfloat16: a processor that only imitates it needs some thirty times as long as in float32."""

import torch


def autocast(device: str, wanted: bool) -> torch.autocast:
    """A context in which the network computes in bfloat16, where that is `wanted` and the device really does."""
    return torch.autocast(device, torch.bfloat16, enabled=wanted and native(device))


def native(device: str) -> bool:
    """Whether bfloat16 is a type of the device's own."""
    if device == "cuda":
        return bool(torch.cuda.is_bf16_supported())
    return bool(torch.ops.mkldnn._is_mkldnn_bf16_supported())
