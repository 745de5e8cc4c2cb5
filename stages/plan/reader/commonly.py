"""Clauses that anybody writes, in those that the other rules know: what is far, where windows look, what was sold."""

from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_ROOM = rf"(?:(?:the|my|our|his|her|their|[a-z]+'s) )?(?:own )?(?:{KIND}|bed ?room(?: \d)?|room)"
_COMPASS = r"(?:north|south)(?:[ -]?(?:east|west))?|east|west"
_COME_IN = (r"(?:when|as|once) (?:you|i|we|one) (?:come|enter|step|walk|go)(?:e?s)?(?: (?:in ?to|in|inside))?"
            r"(?: (?:the |my |our )?(?:flat|apartment|home|house|door|front door))?")  # fmt: skip
_OUT = r"(?:garden|street|park|courtyard|yard|river|sea|lake|road|square|mountains?|forest)"
_HOURS = r"(?:ein|zwei|drei|vier|funf|sechs|sieben|acht|neun|zehn|elf|zwolf|\d{1,2})"
_WORK = (
    r"(?:sew|make|build|design|sell|repair|fix|restore|review|import|tune|collect|paint|test|upholster|deliver|trade)"
)
_KIDS = r"(?:child(?:ren)?|kids?|sons?|daughters?|boys?|girls?|teenagers?|toddlers?|bab(?:y|ies))"
_ELDER = r"(?:grand(?:mother|father|ma|pa)|granny|grandparents?|aunt|uncle)"
_GONE = r"(?:sold|gave away|got rid of|threw out|threw away|scrapped|binned|donated|left behind|lost)"
_HOME = r"(?:flat|apartment|place|home|house)"
_SAID = rules((
    # "our flat now has two bedrooms and we queue for the loo. In the new one we want three bedrooms"
    (r"(?:^|(?<=[.!?;] ))(?:(?:our|my|the) (?:current|present|old|last|previous) {home}|(?:our|my) {home} (?:now|"
     r"currently|today|at the moment)) (?:now )?(?:has|had|have|is|was|only has)\b[^.!?;]*[.!?;] ?(?=[^.]*\b(?:new|"
     r"want|need|like|wish|looking)\b)", ""),
    (r"\bin (?:the|our|my) (?:new|next) (?:one|{home}),? (?=(?:i|we)\b)", ""),
    # "I don't want his room anywhere near mine", "nowhere near the kitchen"
    (r"\b(?:i|we)? ?(?:do not|don't|does not|would not|wouldn't|never) (?:want|like|need|put|have|place) (?P<a>{a}) "
     r"(?:to be )?(?:anywhere |any place |somewhere )(?:near|close to|next to|beside)(?: to)? ", r"\g<a> is far from "),
    (r"\b(?:nowhere|not anywhere) (?:near|close to|next to)(?: to)?\b", "far from"),
    (r"\b(?:{not}) be anywhere (?:near|close to|next to)\b", "must be far from"),
    # "55 m2 at the very most", "is to be twice as large as"
    (r"\bat the (?:very|absolute) (most|least)\b", r"at \1"),
    (r"\b(is|are) to be (?=(?:twice|half|three|at least|at most|the (?:large|small|big)|larger|smaller|bigger|next|"
     r"near|far|as|open|in|on|at|opposite)\b)", "must be "),
    # "windows of the living room to the south, of both bedrooms to the north", "the bedroom window look to the
    # garden, garden is in south"
    (r"\b(?:the )?windows? (?:of|in) (?P<a>{a}) (?:{must} )?(?:(?:be|look|face|go|are|looking|facing|open) )?(?:out "
     r")?(?:to|towards|on|onto|at)?(?: the)? ?(?P<s>{compass})(?:[,;]? (?:and )?(?:those )?(?:of|in) (?P<b>{a}) (?:to|"
     r"towards|on)?(?: the)? ?(?P<t>{compass}))?\b",
     lambda found: f"{found['a']} faces {found['s']}" + (f". {found['b']} faces {found['t']}" if found["b"] else "")),
    (r"(?P<a>{a}) windows? (?:(?:{must}|to) )?(?:looks?|faces?|goes?|opens?)(?: out)? (?:on ?to|to|on|over|at|towards|"
     r"into) the (?P<o>{out})[,;.]? ?(?:and |which |that )?(?:the )?(?:(?P=o) )?(?:is|lies) (?:in|to|on|at)(?: the)? "
     r"(?P<s>{compass})\b", r"\g<a> faces \g<s>"),
    # "when I come in, the kitchen is on the left and the living room on the right", "to the left as you come in"
    (r"\b(?:to|on|at) (?:the|your|my) (left|right)(?:[ -]hand)?(?: side)? {come}", r"to the \1 of the entrance"),
    (r"\b{come},? (?:i want |we want |there is )?(?:that )?(?P<a>{a}) (?:{must} be |is )?(?:to|on|at|in) (?:the|your|"
     r"my) (?P<s>left|right)(?:[ -]hand)?(?: side)?(?:,? and (?P<b>{a}) (?:{must} be |is )?(?:to|on|at|in) (?:the|"
     r"your|my) (?P<t>left|right)(?: side)?)?",
     lambda found: f"{found['a']} is to the {found['s']} of the entrance"
     + (f" and {found['b']} is to the {found['t']} of the entrance" if found["b"] else "")),
    # "a bathroom without a bath, only a shower", "I can't climb into a bathtub any more, so a shower, please"
    (r"\bwithout (?:an? )?bath(?:tub)?,? (?:but )?(?:only|just|but)(?: with)? (?:an? )?shower\b",
     "with a shower and no bathtub"),
    (r"\b(?P<w>(?:with|has|and|want) (?:only |just )?(?:an? )?shower),? (?:but |and )?(?:no|not an?|without an?) "
     r"bath(?: ?tub)?\b(?! ?room)",
     r"\g<w> and no bathtub"),
    (r"\b(?:can't|cannot|can not|can no longer|not able to)(?: \w+){0,3} (?:an? |the )?bath(?:tub)?(?: any ?more| any "
     r"longer)?,? (?:so|and|but) ",
     "want no bathtub, but "),
    # "I sew curtains for a living", "we sold the piano last year", "he works with a computer"
    (r"\b(i|we|he|she|(?:my|our) [a-z]+) (?:also )?{work}s? (?:[a-z]+ )?(?!rooms\b)[a-z]+s\b(?= (?:for a living|at "
     r"home|as a hobby|for a job)\b)",
     r"\1 work"),
    (r"\b{gone} (?:the|our|my|his|her|that|an?) (?:old |big |grand |second )?[a-z]+(?: [a-z]+)?(?= (?:last|years?|"
     r"when|ago|and don't|and do not)| ?[.,;])", "did so"),
    (r"\b((?:work|play|job|lesson|stud)(?:s|ies|ing)?) (?:with|on|at|by) (?:the |an? |his |her |my )?(?:computer|"
     r"laptop|pc)s?\b", r"\1"),
    # "the kitchen, so make it large", "a big kitchen, 18 m2 at least, with two ovens", "neither over 12 m2"
    (r"(?P<said>\b(?P<a>the {kind})\b[^.;]{0,60}?)\bmake it (?=(?:large|big|small|huge|bright|wide|open)\b)",
     r"\g<said>make \g<a> "),
    (r"(?P<a>\b(?:an?|the) (?:[a-z]+ )?{kind}), (?P<n>{amount} ?{unit}) (?P<l>at (?:least|most))(?=, with )",
     r"\g<a> of \g<l> \g<n>"),
    (r",? neither (?:of them |one )?(?:over|above|larger than|bigger than|more than) (?P<n>{amount} ?{unit})",
     r". each bedroom is at most \g<n>"),
    # "not make door between kitchen and living room", "no door kitchen/living room", "nada de puerta entre", "tür
    # zwischen"
    (r"\b(?:do )?not make (?:an? |any )?doors? between\b", "no door between"),
    (r"\bno doors? ({kind}) ?/ ?({kind})", r"no door between \1 and \2"),
    (r"\bnada de puertas? entre\b", "ninguna puerta entre"),
    # "oriented to the south and 5 x 4.5 m", "lejos de la cocina y de la entrada", "looks out west, the other one east"
    (r"(?P<a>{a}) (?:is )?oriented to(?:wards)? the (?P<s>{compass}) and (?P<x>{amount} ?(?:x|by) ?{amount} ?m\b)",
     r"\g<a> faces \g<s>. \g<a> measures \g<x>"),
    (r"\b(?P<f>lejos|cerca) de (?P<a>(?:la|el) {es}) y de (?P<b>la entrada)\b", r"\g<f> de \g<a> y \g<f> de \g<b>"),
    (r"\b(?P<a>{a}|mine|ours|hers|his) looks? out(?: to(?: the)?)? (?P<s>{compass}),? (?:and )?(?P<b>the other one|"
     r"{a}|mine|ours|hers|his) (?:looks? out )?(?P<t>{compass})\b",
     lambda found: f"{_either(found['a'])} faces {found['s']}. {_either(found['b'])} faces {found['t']}"),
    (r"(?<=, )(?P<n>{amount} ?{unit})(?P<w>, with an? (?:single|double|bunk) bed)", r"\g<n> in total\g<w>"),
    # "speisekammer, in die man von der kuche aus kommt"
    (r"(?P<a>{de}),? in (?:die|den|das) man (?:direkt )?von (?:der|dem) (?P<b>{de})(?: aus)? (?:kommt|gelangt|geht|"
     r"tritt)", r"\g<a> an der \g<b>"),
    # "the other one for the grandchildren, with two single beds", "one bedroom with the bathroom opposite it"
    (r"\bthe other (?:one|bed ?room)? ?(?:is )?for (?:the|our|my) [a-z]+,? with (?P<w>(?:an?|one|two|three|\d) "
     r"[a-z ]+?){end}",
     r"the other bedroom has \g<w>"),
    (r"\b(one|a|the) (bed ?room) with the (bath ?room|kitchen|study) (opposite|next to|beside|near) it\b",
     r"\1 \2. the \3 is \4 the \2"),
    (r"\btwo bathrooms[:,] ours (?:straight |directly |right )?(?:off|in|inside|through) our bedroom",
     "two bathrooms: one off our bedroom"),
    # "small room for wash the clothes, you go in from kitchen", "a cabinet for shoes", "Accessibility study. One
    # bedroom …"
    (r"\broom (?:for|to) wash(?:ing)? (?:the |our |my )?(?:clothes|laundry)(?:,? (?:that )?(?:you|i|we|one) (?:go|get|"
     r"enter)s?(?: in)?(?: to it)? from (?:the )?(?P<k>{kind}))?",
     lambda found: "laundry room" + (f" reached from the {found['k']}" if found["k"] else "")),
    (r"\b(?:cabinet|cupboard) for (?:the |my |our )?shoes\b", "shoe cabinet"),
    (r"^(?:[a-z-]+ ){0,2}(?:accessibility|usability|feasibility|pilot|user|lighting|sleep|energy|noise|privacy|"
     r"housing) study(?=[.:] )",
     "research"),
    # "un bureau avec une porte sur le couloir mais pas sur le salon", "el salón, el doble de grande que la cocina y
    # con salida a la terraza"
    (r"\bune porte sur (?:le |la )?({fr}) mais pas sur (?:le |la )?({fr})",
     r"une porte sur le \1 et sans porte vers le \2"),
    (r"(?P<a>\b(?:el|la) (?:{es})), (?P<x>el doble de grande que [^.;,]*?) y con (?P<y>[^.;]*)",
     r"\g<a>, \g<x>. \g<a> con \g<y>"),
    (r"(?P<n>[两二三四])个孩子,?(?:孩子)?们?一人一间(?:房间?|卧室)?", r"\g<n>个孩子各有一间房"),
    # "one bathroom is plenty, but with a bath in it", "the kitchen is where I spend my day: at least 18 m2", "eating
    # on the sofa"
    (r"\bwith (?:a|one) bath in (?:it|the bath ?room)\b", "with a bathtub in the bathroom"),
    (r"(?P<a>\b(?:the|my|our) {kind}) is where [^:;.]*?: (?P<l>(?:at (?:least|most)|no (?:less|more) than) {amount} "
     r"?{unit})", r"\g<a> is \g<l>"),
    (r"\b(eating|sleeping|working|sitting|lying|studying) (?:on|at|in|off) (?:the|a|my|our) (?!kitchen|bed ?room|"
     r"living|dining|study)[a-z]+(?= ?[.,:;])",
     r"\1"),
    (r",? or (?:else )?the (?:shower|noise|light|sun|smell|steam|neighbours?|dogs?|cats?|baby|kids|children|street|"
     r"trams?|music|tv|piano|drums) (?:will|would) [^.;,]*", ""),
    # "a terrace I can step onto from both the living room and the bedroom", "two studies then, far apart"
    (r"(?P<b>\b(?:balcony|terrace)) (?:that )?(?:i|we|you) (?:can|could) (?:step|go|walk|get)(?: out)? (?:on ?to|to) "
     r"from (?:both )?(?P<a>{a}) and (?:from )?(?P<c>{a})", r"\g<b> with a door to \g<a> and a door to \g<c>"),
    (r"\b(?P<n>two (?:studies|bed ?rooms|offices|bath ?rooms))(?: then)?, far apart\b", r"\g<n> far from each other"),
    (r"\b(?P<n>two [a-z']+ ?rooms) of (?:equal|the same) size next to each other\b",
     r"\g<n> next to each other and of the same size"),
    # "a bunk bed in the girls'", "opposite the player's"
    (r"\b(?P<p>in|next to|beside|opposite|near|from) (?P<w>(?:the|my|our) [a-z]+(?:s'|'s)),? ?(?=[.,;]|$|and\b|"
     r"but\b)", r"\g<p> \g<w> room "),
    # "from the bedroom into a dressing room and from there into the bathroom", "entered from the living room, not
    # from the hall"
    (r"\bfrom (?P<a>{a}) (?:straight )?into (?:an? |the |our )?(?P<c>dressing room|walk-in closet|closet)\b,? and "
     r"from (?:there|it|the (?:closet|dressing room)) (?:straight )?into (?:an? |the |their |our )?(?P<b>bath ?room|"
     r"en ?suite)", r"a \g<c> off \g<a>. the \g<b> is reached from the \g<c>"),
    (r"(?P<a>\b(?:the|my|our) {kind}) (?:is|must be|should be) (?:entered|reached) (?:only )?from (?P<b>{a}),? (?:and "
     r")?not from (?P<c>{a})",
     r"\g<a> has a door to \g<b> and no door to \g<c>"),
    (r", (?:and )?not doors? to (?=(?:the )?{kind})", ", no door to "), (r"\bthe both\b", "both"),
    (r"\bdormitorio, pequen[oa],", "dormitorio pequeno"),
    (r"\b(?P<w>facing|faces?|to the|in the|towards) (?:wset|wets|esat|aest|nroth|norht|noth|sotuh|suoth|soth)\b",
     lambda found: f"{found['w']} {_slip(found.group().split()[-1])}"),
    (r"^(?:an? )?[a-z]+[- ]detection study\b", "research"),
    # "有阳台,洗衣机放在阳台上"
    (r"(?P<b>阳台[^;]*?)放在?阳台上?", r"\g<b>在阳台"),
    # "across from the bathroom and no less than 15 m2", "living room not above 14 m2", "has to stay within 50 m2"
    (r"(?P<a>\b(?:the|my|our|his|her|their) (?:{kind}|bed ?room)) (?P<m>{must}) be (?P<x>[^.;,]*?) and (?P<l>(?:no "
     r"(?:less|more)|not (?:less|more)) than|at (?:least|most)) (?P<n>{amount} ?{unit})",
     lambda found: f"{found['a']} {found['m']} be at {'most' if 'mo' in found['l'] else 'least'} {found['n']}. "
     f"{found['a']} is {found['x']}"),
    (r"(?P<a>{kind}) not (?:above|over|larger than|more than|bigger than) (?P<n>{amount} ?{unit})",
     r"\g<a> at most \g<n>"),
    (r"\b(?:has to|must|should|needs to) (?:stay|be|remain) within (?P<n>{amount} ?{unit})", r"is at most \g<n>"),
    # "storage room off the hallway, near the entrance", "seen from the entrance, the study is on the left and the
    # kitchen on the right"
    (r"(?P<a>{kind}) off the (?P<h>{hall}), (?:close to|near|by) the (?P<e>entrance|front door)(?!-)",
     r"\g<a> off the \g<h>. the \g<a> is near the \g<e>"),
    (r"\b(?:as )?seen from the (?:entrance|front door),? (?P<a>{a}) is (?:to|on|at) the (?P<s>left|right)(?:,? and "
     r"(?P<b>{a}) (?:is )?(?:to|on|at) the (?P<t>left|right))?",
     lambda found: f"{found['a']} is to the {found['s']} of the entrance"
     + (f" and {found['b']} is to the {found['t']} of the entrance" if found["b"] else "")),
    (r"\b(?:to|on|at) the (left|right)(?: side)?,? (?:as )?seen from the (?:entrance|front door)",
     r"to the \1 of the entrance"),
    # "a study where I can practise, well away from the bedroom", "in the living room I work, so there I need a desk"
    (r"(?P<a>\b(?:an?|the) (?:small |large |big )?{kind}) where (?:i|we) (?:can )?[^,.;]{3,40}, (?P<x>(?:well |far "
     r")?away from|far from|next to|near)\b",
     r"\g<a> \g<x>"),
    (r"\bin (?P<a>(?:the |my |our )?{kind}) (?:i|we) (?:work|study|eat|sleep|play|sew|paint)[^.;,]*?, so there (?:i|"
     r"we) (?:need|want)", r"in \g<a> i need"),
    (r"\b(balcony|terrace) from (?:the )?({kind})(?= ?(?:[.,;]|$|please))", r"\1 off the \2"),
    (r"(?P<a>bed ?room), it ha(?:s|ve) (?:the|an?) (?P<b>balcony|terrace|closet)\b", r"\g<a> with a \g<b>"),
    (r"\bin (?:die|den|das) (?P<a>{de}) (?:soll|mochte|kann|will) (?:man|ich) (?:direkt )?von (?:der|dem) "
     r"(?P<b>{de})(?: aus)? (?:kommen|gelangen|gehen|treten)(?: konnen)?", r"die \g<a> ist an der \g<b>"),
    (r"\bal (?P<a>{es}), con (?P<w>[^.;]*?), se entra (?:por|desde) (?P<b>(?:la |el )?{es})",
     r"al \g<a> se entra por \g<b>. el \g<a> tiene \g<w>"),
    (r"阳台从(?P<a>主?卧室?|客厅|厨房)出去", r"阳台连着\g<a>"), (r"之间不要(?:开|有|设)?门", "之间没有门"),
    # "the guest room can be small", "make the kitchen large, with an island, and open to the living room"
    (r"(?P<a>{a}) (?:can|may|could) be (?:quite |rather |very |fairly )?(small|tiny|little)\b", r"\g<a> is small"),
    (r"\bmake (?P<a>{a}) (?P<s>large|big|small|huge|spacious),? with (?P<w>[^.;]*?),? and (?:have it |make it )?open "
     r"to (?P<b>{a}){end}",
     r"\g<a> is \g<s>. \g<a> has \g<w>. \g<a> is open to \g<b>"),
    # "a laundry room beside the kitchen with a washing machine"
    (r"\b(?P<a>(?:an? |the )?(?:laundry|utility)(?: room)?) (?P<by>(?:next to|beside|near|close to|off|opposite) "
     r"(?:the )?{kind}) with (?P<w>[^.,;]*?){end}", r"\g<a> with \g<w>, \g<by>"),
    # "um sechs" is no number of rooms
    (r"\b(?:um|gegen|bis|ab) {hours}(?: uhr)?(?: (?:fruh|morgens|abends|nachts))?(?= (?:mit|in|im|auf|zu|am|an|und|"
     r"das|der|die|den)\b| ?[.,;])", ""),
    # "a couple with a newborn baby", "a hotel room", which has no kitchen unless it is told
    (r"\bnew ?born bab(y|ies)\b", r"bab\1"),
    (r"^(?:an? |one )?(?P<b>[a-z]+ )?(?:hotel|motel)(?: bed)? ?room\b(?!s)(?!.*\b(?:bed ?room|bath ?room|"
     r"kitchen(?:ette)?|shower|living)\b)(?P<r>[^.]*)",
     r"a \g<b>bedroom with an ensuite bathroom\g<r>. no other rooms"),
    # "an apartment for an artist with a studio", which is a room of it
    (r"(?P<h>\b{home} (?:for|of) [^.,;]*? with an? (?:small |large |bright |art |music |photo )?)studio\b(?! (?:{home}|"
     r"kitchen))", r"\g<h>study"),
    # "max 50 m2 one-bedroom flat", "a small two-room apartment"
    (r"^(?:an? )?(?P<l>(?:max(?:imum|\.)?|at most|up to|under|below|less than|no more than|at least|min(?:imum|\.)?|"
     r"over|more than) {amount} ?{unit}),? (?P<h>(?:[a-z]+ ){0,2}(?:{number})[- ]?bed(?:[- ]?room)?s? {home}\b)",
     r"\g<h>, \g<l>"),
    (r"\b(small|tiny|compact|large|big|spacious) (?P<n>(?:two|three|four|five|[2-5])[- ]?rooms?) (?P<h>{home}\b)",
     r"\1 \g<h> of \g<n>"),
    # "bedrooms must not touch", "the front door opens straight into the living room", "one of which is an office"
    (r"\b({must}) not touch(?: each other| one another)?{end}", r"\1 not be next to each other"),
    (r"\b({must}) not touch (?={a}\b)", r"\1 not be next to "), (r"\b({must}) touch (?={a}\b)", r"\1 be next to "),
    (r"^(?:the )?(?:entrance|front door) (?:{must} )?(?:opens?|leads?|goes) (?:directly |straight |right )?(?:in)?to ",
     "the entrance leads into "),
    (r"(?P<s>\bbed ?rooms),? (?:and )?one of (?:which|them) (?:is|will be|would be|should be) (?:an? |my |our "
     r"|the )?(?P<u>home office|office|study)\b", r"\g<s>, one used as a \g<u>"),
    # "kleine Dreizimmerwohnung", "petit trois-pièces", "piso pequeño", "60 m2 große Wohnung", "chambre d'hôtel"
    (r"\b(klein|gross)e[rns]? (?P<n>zwei|drei|vier|funf|[2-5])[- ]?zimmer[- ]?wohnung\b",
     r"\1e wohnung mit \g<n> zimmern"),
    (r"({amount} ?{unit}) grosse[rns]? (?=[^ ]*(?:wohnung|haus|apartment|studio)\b)", r"\1 "),
    (r"\b(petit|grand) (?P<n>deux|trois|quatre|cinq|[2-5])[- ]pieces\b", r"\1 appartement de \g<n> pieces"),
    (r"\b(piso|apartamento) (pequeno|grande)\b", r"\2 \1"),
    (r"^(?:ein |une |un |una |一[个间])?(?:(?:hotel|motel)zimmer|chambre d'hotel|habitacion de hotel|"
     r"(?:酒店|宾馆|旅馆)的?(?:客房|房间))(?=[ .,]|$)(?!.*\b(?:bad|kuche|bain|cuisine|"
     r"bano|cocina)\b)(?P<r>[^.]*)", r"a bedroom with an ensuite bathroom\g<r>. no other rooms"),
    # "a family with two children and a grandmother": the parents live there, too
    (r"\bfamily with (?=[^.;]*\b{kids}\b)(?=[^.;]*\b{elder}\b)(?!the\b)", "couple with "),
    (r"\bfamilie mit (?=[^.;]*\bkind(?:ern)?\b)(?=[^.;]*\b(?:oma|opa|gross(?:mutter|vater))\b)", "paar mit "),
    (r"\bfamille avec (?=[^.;]*\benfants?\b)(?=[^.;]*\bgrand-(?:mere|pere)\b)", "couple avec "),
    (r"\bfamilia con (?=[^.;]*\b(?:hij|nin)[oa]s?\b)(?=[^.;]*\babuel[oa]\b)", "pareja con "),
    # "tree bedrooms", "a live-in grandmother", "bureau dans la chambre", "toilettes loin de la cuisine"
    (r"\btree (?=(?:bed ?|bath ?)?rooms?\b|{kids}\b|people\b|balconies\b|windows\b)", "three "),
    (r"\blive-in (?=grand|mother|father|aunt|uncle|parents)", ""),
    (r"(?<!un )\bbureau dans (?=(?:la|une|chaque|les) chambres?\b)", "table de travail dans "),
    (r"(?<!x )(?<!s )(?<!\d )\b(?:les |des )?toilettes (?=(?:loin|pres|a cote|au|dans)\b)", "wc "),
    (r"(?P<n>[两二三四])室(?P<r>(?:[一两二]厅)?(?:一厨)?(?:[一两二]卫)?),?其中一[间个](?:卧室|房间)?(?:做|当作?|用作|作为|改成)书房",
     lambda found: f"{'一两三'['两三四'.find(found['n'].replace('二', '两'))]}室{found['r']}一间书房"),
    # "children is three"
    (r"\bchildren (?:is|are) ({number})\b", r"\1 children"),
    # "18 m2 is plenty for the living room", "a room with two bunk beds", "each with a wardrobe, and no door between
    # the two"
    (r"\b(?P<n>{amount} ?{unit}) (?:is|are|will be|would be) (?:plenty|enough|fine|sufficient|okay|ok) for "
     r"(?P<a>{a}){end}",
     r"\g<a> is \g<n>"),
    (r"\b(an?|one|another) room with (?=(?:an?|one|two|three|four|\d) (?:bunk|single|double|twin) beds?\b)",
     r"\1 bedroom with "),
    (r"(?P<a>\b(?:bed ?)?room for [^.;]{1,40}? and one for [^.,;]{1,40}), each with (?P<w>an? [a-z]+)(?=[,.;]|$| and)",
     r"\g<a>. each bedroom has \g<w>. "),
    (r"(?P<b>\b(?:(?:two|both|the) bed ?rooms|each bed ?room)\b[^.;]*?\b(?:with |and )?no door between )(?:the two|"
     r"them)(?: of them)?{end}",
     r"\g<b>the two bedrooms"),
    # "you should get to it from my bedroom, not from the living room", of a balcony
    (r"(?P<b>\b(?:balcony|terrace)\b[^.;]*[.;] ?)(?:i|you|we|one) (?:{must} |want to |would like to |'d like to "
     r")?(?:get|go|step|walk|come) (?:on ?to|to|in ?to|out on) it from (?P<a>{a}),? (?:and )?not (?:from )?(?P<c>{a})",
     r"\g<b>the balcony is reached from \g<a> and not from \g<c>"),
    (r"\bauf (?:den|einen) balkon (?:mochte|will|soll|kann|wurde) (?:ich|man|wir) vom (?P<a>{de})(?: aus)? (?:gern "
     r")?(?:treten|gehen|kommen|gelangen)(?: konnen)?,? (?:und )?nicht vom (?P<b>{de})",
     r"der balkon geht vom \g<a> ab und hat keine tur zum \g<b>"),
    # "zwei Kinder, und jedes soll sein eigenes Zimmer bekommen"
    (r"(?P<n>zwei|drei|vier) (?P<k>kinder|tochtern?|sohnen?|jungs|teenager)\b[,:;.]? (?:und )?jede[sr]?(?P<v> (?:soll|"
     r"bekommt|braucht|hat|will|mochte|sollte))? (?:sein|ihr)(?: eigenes)? zimmer(?: haben| bekommen)?",
     r"\g<n> \g<k>, jedes\g<v> ein eigenes zimmer bekommen"),
    # "3间卧室", "三卧一卫"
    (r"(?<![\d.a-z])(?<!\d,)(?P<n>[1-9])(?=[间个张把台盏盆卧卫居厨])",
     lambda found: "零一两三四五六七八九"[int(found["n"])]),
    (r"(?P<n>[一二两三四五六])卧(?=[一二两三1-9,.;]|$|带|朝)", r"\g<n>间卧室"),
    (r"(?P<n>[一两二三])厨(?!房)", r"\g<n>个厨房"),
), a=_ROOM, kids=_KIDS, elder=_ELDER, compass=_COMPASS, come=_COME_IN, out=_OUT,
   hours=_HOURS, work=_WORK, gone=_GONE, home=_HOME)  # fmt: skip


def _either(room: str) -> str:
    """`the other one`, `mine` as bedrooms."""
    return {"the other one": "bedroom 2", "mine": "bedroom 1", "ours": "bedroom 1"}.get(room, room)


def _slip(word: str) -> str:
    """The side that was meant: letters that changed places or are missing."""
    return next(side for side in ("west", "east", "north", "south") if set(word) <= set(side))


_ENOUGH = Late(
    r"(?:^|(?<=[.;,!] ))(?:just |only )?(?:one|a single) bed ?room (?:is|will be|would be) "
    r"(?:enough|plenty|fine|all i need)\b(?! for (?!me\b|us\b|the two of us))"
    r"(?:, (?P<n>\d+(?:\.\d+)? ?(?:m2|sqm)))?[.!]?"
)


def commonly(text: str) -> str:
    """A folded text with such clauses reworded; `one bedroom is enough` is said first, as it is of all that is told."""
    said = reworded(text, _SAID)
    found = _ENOUGH.search(said)
    area = f"the bedroom is {found['n']}. " if found and found["n"] else ""
    return f"a one-bedroom flat. {area}{_ENOUGH.sub('', said).strip()}" if found else said
