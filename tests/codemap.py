"""Which room of the code imports which, read from the source, as a Mermaid flowchart."""

from pathlib import PurePath

import networkx
from test_house import MODULES, RELATIVE, imported, module


def room(file: str) -> str:
    """The room that a file stands in: a folder of the stages, else one at the top level."""
    parts = PurePath(file).parts
    return "/".join(parts[:2]) if parts[0] == "stages" and len(parts) > 2 else parts[0]


def rooms() -> networkx.DiGraph:
    """Arrows from each room to those it imports, whether at the top of a file or when called."""
    graph = networkx.DiGraph()
    for file in RELATIVE:
        graph.add_node(room(file))
        graph.add_edges_from((room(file), room(MODULES[name])) for _, name in imported(file)
                             if name in MODULES and name != module(file) and room(MODULES[name]) != room(file))
    graph.remove_nodes_from([name for name in graph if name == "stages"])
    return graph


def flowchart() -> str:
    """The rooms from the user's side down; an arrow that goes without saying, by way of others, is left out."""
    graph = rooms()
    shown = networkx.transitive_reduction(networkx.DiGraph((a, b) for a, b in graph.edges if (b, a) not in graph.edges))
    names = {name: name.replace("/", "_") for name in sorted(graph)}
    lines = ["flowchart TD", *(f"    {names[name]}[{name}]" for name in names),
             *(f"    {names[a]} --> {names[b]}" for a, b in sorted(shown.edges))]
    return "\n".join(lines) + "\n"
