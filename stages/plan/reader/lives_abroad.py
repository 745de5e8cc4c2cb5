"""What people tell of how they live, in German, French, Spanish and Chinese, in words the rules know."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_NACH = {"nord": "norden", "sud": "suden", "ost": "osten", "west": "westen"}

_SAID = rules((
    # "mit unserem Baby, das noch bei uns schläft", "unsere Kinder teilen sich ein Zimmer", "Sonst nichts Besonderes"
    (r"\bwir sind (?:zu dritt|drei),? mit (?:unserem|dem|einem) baby, das (?:noch )?bei uns schlaft\b",
     "wir sind ein paar"),
    (r"\b(?:unsere|die|meine)(?: zwei| beiden)? (?:kinder|tochter|sohne|jungs|madchen)(?: sind [\d und,]+(?:jahre alt "
     r")?)?(?: und)? teilen sich ein zimmer\b(?!.*schlafzimmer)", "ein elternschlafzimmer und ein kinderzimmer"),
    (r"[,;.]? ?(?:und )?(?:sonst|ansonsten) (?:nichts (?:besonderes|weiter besonderes)|wie ublich|alles wie "
     r"ublich){end}", ""),
    (r"\bein(?:en)? (?:zimmer|raum) (?=zum (?:malen|musizieren|nahen|arbeiten|basteln|schreiben)\b)",
     "ein arbeitszimmer "),
    (r"\bmit (nord|sud|ost|west)licht\b", lambda found: f"nach {_NACH[found[1]]}"),
    (r"\bvo[mn] (?:der )?(\w+) (?:geht|fuhrt|offnet sich)(?: dann| auch)? eine tur (?:ins|in den|in die|zum|zur) (\w+)",
     r"der \1 hat eine tur zum \2"),
    # "on est trois colocataires", "pas besoin de salon", "un studio avec un bureau"
    (r"\b(?:on est|nous sommes) (?=(?:deux|trois|quatre|cinq) (?:colocataires|colocs|etudiant[e]?s|amis|amies)\b)",
     "pour "),
    (r"\b(deux|trois|quatre|cinq) (?:colocataires|colocs)\b(?!.*\bchambres?\b)", r"\1 chambres pour \1 colocataires"),
    (r"(^|[.,;:] ?)(?:pas|nul) besoin (?:de |d'une? )(?={fr})", r"\1sans "),
    (r"^((?:un |le )?studio\b[^.]*?\b(?:avec|et)) un bureau\b(?! (?:separe|ferme|a part))", r"\1 une table de travail"),
    (r"\bdeux chambres eloignees l'une de l'autre\b", "deux chambres. the bedrooms are far from each other"),
    (r"\bpas plus de ({amount}) ?(?:m|metres) de (long|large)(?:ueur|geur)? pour le (couloir|hall)\b",
     r"le \3 pas plus de \1 m de \2"),
    # "el de mis padres cerca del baño, y el nuestro al fondo"
    (r"\bel dormitorio de mis padres ([^.;]*?),? y el nuestro (?=al|cerca|junto|lejos)",
     r"el dormitorio de mis padres \1. nuestro dormitorio "),
    # "我们的卧室在最里面"
    (r"在(?:最|房子)?里(?:面|边|头)(?=[,.;]|$)", "在后面"),
    # "eine offene Küche möchte ich nicht", "ins erste kommen ein Bett und …, ins zweite ein Schreibtisch"
    (r"\b(eine?n? [a-z ]{3,30}?) (?:mochte|will|brauche|wollen|mochten|brauchen) (?:ich|wir) nicht\b", r"k\1"),
    (r"\bins (erste|zweite|dritte)(?: schlafzimmer)?(?: kommen| kommt| sollen| soll| gehoren| gehort)? (?=ein|zwei|"
     r"das)",
     r"im \1n "),
    # "un bureau où l'on entre par le séjour", "accessible à la fois de la chambre et du couloir", "c'est pour mes
    # parents"
    (r",? ?ou (?:l')?on entre (par|depuis) ", r" accessible \1 "),
    (r"\b(accessibles?|donnant) a la fois (?=de|du|depuis|sur)", r"\1 "),
    (r"^c'est pour (?:mes|nos|des) [a-z]+(?: ages)? ?: ?", ""),
    # "cada pareja con su dormitorio y su baño dentro", "tiene que ser la habitación más grande"
    (r"\b(?:somos )?(dos|tres) parejas\b[^:;.]*[:;.,] ?(?:y )?cada (?:pareja|una) con su dormitorio y su bano(?: "
     r"dentro| propio| privado)?", r"\1 dormitorios, cada uno con su bano propio"),
    (r"\b(dos|tres|cuatro) dormitorios, (?:el|uno) (?=de mi (?:madre|padre|abuel[oa]|suegr[oa]|hij[oa]|herman[oa])\b)",
     r"\1 dormitorios. el dormitorio "),
    (r"\b(?:tiene que|debe|ha de|deberia) ser (?=la (?:habitacion|estancia|pieza) mas)", "es "),
    # "卫生间的门都开在走廊上", "次卧兼作书房"
    (r"((?:卫生间|浴室|卧室))的门(?:都|全)(?:要|应该)?(?:开在|开向|通向|朝)走廊(?:上|里)?", r"\1都从走廊进"),
    (r"(爸妈|父母|老人|爷爷奶奶|孩子)(?:的)?那[间个](?![房卧])", r"\1的卧室"),
    (r"(次卧|主卧|卧室)兼(?:作|做|当|用作)?(?:书房|办公室|客房),?", r"\1里"),
))  # fmt: skip


def lived_abroad(text: str) -> str:
    """A folded text with such clauses in plain words."""
    return reworded(text, _SAID)
