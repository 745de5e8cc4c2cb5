"""Rooms with one way in, as French, Spanish and learners say it: `n'est accessible que par`, `entered by`."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_ARE = {
    "den": "dan", "miren": "miran", "abran": "abren", "tengan": "tienen", "esten": "estan", "sean": "son",
    "midan": "miden", "de": "da", "mire": "mira", "abra": "abre", "tenga": "tiene", "este": "esta", "sea": "es",
    "mida": "mide",
}  # fmt: skip
"""Spanish verbs of what is wished for as those of what is."""
_SAID = rules((
    # "dos dormitorios que den al sur"
    (r"\bque (?P<verb>den|miren|abran|tengan|esten|sean|midan|de(?= al? )|mire|abra|tenga|este|sea|mida)\b",
     lambda found: f"que {_ARE[found['verb']]}"),
    # "la cuisine n'est accessible que depuis le salon", "un dormitorio al que solo se accede por el salón"
    (r"\bn'(?P<is>est|sont) (?P<how>accessibles?|reliee?s?) (?:que|uniquement que) (?=(?:par|depuis|via|de|du|a)\b)",
     r"\g<is> accessible uniquement "),
    (r"\bon n'(?:accede|entre|arrive) (?:a la|a l'|au|dans la|dans le|dans l') ?(?P<of>\w+(?: parentale| d'amis)?) "
     r"que (?:par|depuis|via) ",
     r"la \g<of> accessible uniquement par "),
    (r"\b(?:a laquelle|auquel|ou) (?:l')?on n'(?:accede|entre|arrive) que (?:par|depuis|via) ", "accessible "
     "uniquement par "),
    (r"(?P<of>\b(?:le|la|l') ?\w+) ne (?:s'ouvre|communique|donne) qu(?:e |')(?:sur|avec|dans) ",
     r"\g<of> accessible uniquement par "),
    (r"\b(?:al|a la|a los|a las) que (?:solo|solamente|unicamente) se (?:puede )?(?:accede|acceder|entra|entrar|"
     r"llega|llegar) "
     r"(?:por|desde|a traves de) ", "accesible solo desde "),
    (r"\b(?:solo|solamente|unicamente) se (?:puede )?(?:accede|acceder|entra|entrar|llega|llegar) (?:al|a la) (?"
     r"P<of>\w+) "
     r"(?:por|desde|a traves de) ", r"el \g<of> es accesible solo desde "),
    (r"\b(?:al|a la) (?P<of>\w+(?: de \w+| principal)?) (?:solo|solamente|unicamente) se (?:puede )?(?:accede|"
     r"acceder|entra|entrar|llega|"
     r"llegar) "
     r"(?:por|desde|a traves de) ", r"el \g<of> es accesible solo desde "),
    (r"只能(?=从|由)", ""),
    (r"\b(?:nobody|no one|no-one|you cannot|you can't|one cannot|you don't|you do not) (?:can )?(?:gets?|comes?|"
     r"goes|go|enters?|walks?|steps?)(?: in)?(?: ?to)? "
     r"(?P<of>(?:the|my|our) {kind}) (?:except|but|other than|save|unless) (?:through|from|via|by way of|by) ",
     r"\g<of> is reached only from "),
    # "a pantry you can only get into from the kitchen"
    (r"(?<=[a-z]),? (?:which |that )?(?:you|we|one|i|people) (?:can |should |may )?only (?:be able to )?"
     r"(?:get|go|step|walk|come) (?:in|on)?to (?:only )?(?:from|through|via|by) (?=(?:the|our) {kind})", " reached "
     r"only from "),
    # "he escapes by the balcony"
    (r"\b((?:escape|flee|leave|exit|climb(?:s? out)?|sneak(?:s? out)?)(?:e?s)?) by (?=the {kind})", r"\1 through "),
    # "a pantry that you enter by the kitchen"
    (r",? (?:where|which|that|to which|in which|into which) (?:we|you|one|i|people) (?:can |should )?(?P<only>only )"
     r"?enters? (?P<then>only )?(?:it )?(?:by|from|through|via) ",
     lambda found: f" {'only ' if found['only'] or found['then'] else ''}entered from "),
    (r"\b(?:entered|accessed|reached) by (?=(?:the|our|an?) )", "entered from "),
    (r",? with (?:the |an? |its )?(?:entrance|entry|access) (?:by|from|through|via) (?=(?:the|our) {kind})",
     " entered from "),
))


def only_ways(text: str) -> str:
    """A folded text with such rooms `accessible only from` others."""
    return reworded(text, _SAID)
