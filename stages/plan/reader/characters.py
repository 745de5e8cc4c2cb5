"""Chinese clauses of walls, neighbours, sides of the entrance and people's rooms in words that the rules know."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_CLOSED = re.compile("厨房(?:要|是)?(?:不要|不想要?|不能|不可以|不|别|非)(?:做成?|是|要)?开放|"
                     "(?:封闭|独立)式?的?厨房|厨房(?:要|是)?(?:封闭|独立)")
_LIVED = "(?:(?:开放式|大|小)?(?:客厅|厨房|餐厅|饭厅|起居室))"
_WHOSE = {"我": "my room", "父母": "the parents' bedroom", "爸妈": "the parents' bedroom",
          "爸爸妈妈": "the parents' bedroom"}  # fmt: skip
_SIDES = {"左": "left", "右": "right"}


def _beside_door(found: re.Match[str]) -> str:
    """`入口左边是厨房，右边是客厅` with both rooms before their sides, which are those of the entrance."""
    first, other = _SIDES[found["side"]], _SIDES["右" if found["side"] == "左" else "左"]
    told = f"{found['room']} {first} of the entrance"
    return f"{told}, {found['second']} {other} of the entrance" if found["second"] else told


def _away(found: re.Match[str]) -> str:
    """`厨房和卧室不要相邻` as the one not beside the other."""
    return f"{found['a']}不要挨着{found['b']}"


def _each(found: re.Match[str]) -> str:
    """`我和两个同学合租，每人一间卧室`: as many bedrooms as people."""
    count = int(found["n"]) if found["n"].isdigit() else _NUMBERS[found["n"]]
    count += bool(found["me"])
    return f" for {count} flatmates,{'一两三四五六七'[count - 1]}个卧室" if count > 1 else found.group()


def _family(found: re.Match[str]) -> str:
    """`两个大人和两个孩子，每个孩子一间卧室`: theirs and the parents'."""
    return f" a parents' bedroom, {_NUMBERS.get(found['n'], found['n'])} kids rooms "


def _of_whom(found: re.Match[str]) -> str:
    """`一间女儿住`: a room of theirs, or one of those counted."""
    counted = re.search(r"[一两二三四五2-5](?:个|间)?(?:卧室|室|房间|居)", found.string[: found.start()])
    return "" if counted else f"{found['one']}{'儿童房' if found['kid'] else '卧室'}"


_BED = "(?:主卧室?|次卧室?|客房|[大小]?卧室|[大小南北东西]卧|[大小](?:房间|间|房))"
_KID = "(?:[大小]?女儿|[大小]?儿子|小?孩子?|宝宝|老[大二三])"
_WHO = (rf"(?:[我他她]的?)?(?:{_KID}|父母|爸妈|爸爸妈妈|老人|爷爷奶奶|外公外婆|奶奶|爷爷|外婆|外公|妈妈|爸爸|保姆|"
        "我们?(?:夫妻|夫妇)?|夫妻|夫妇|哥哥|姐姐|弟弟|妹妹)")  # fmt: skip
_NUMBERS = {"一": 1, "两": 2, "二": 2, "三": 3, "四": 4, "五": 5, "六": 6}
def _closed_there(found: re.Match[str]) -> str:
    """Rooms that are joined by a door where the kitchen must not be open."""
    closed = _CLOSED.search(found.string) is not None and "厨房" in found.group()
    return f"{found['a']}连着{found['b']}" if closed else found.group()


_SAID = rules((
    # "两个大人和两个孩子，每个孩子一间卧室"
    (r"(?:我们)?(?:两个|两位|2个)?(?:大人|成人|夫妻|夫妇)(?:俩|两人)?(?:和|带着?|与|,|、)(?P<n>[一两二三四五2-5])个?(?:小?孩子?|儿子|女儿)"
     r"[,;.、]?每个(?:小?孩子?|儿子|女儿)(?:都)?(?:要|有|住|需要)?(?:一间|一个|自己的|单独的|独立的)+"
     r"(?:卧室|房间|房)", _family),
    # "三个同事合租，每人一个房间"
    (r"(?P<me>我(?:和|跟|与))?(?P<n>[一两二三四五六2-6])(?:个|位|名)?(?P<who>(?![^,.;:]*(?:孩|儿子|女儿|夫妻))[^,.;:卧房室厅卫\d]{1,8}|[^,.;"
     r":卧房室厅卫\d]{0,3}室友[^,.;:卧房厅卫]{0,4})"
     r"(?:的(?:房子|公寓|家))?[,:、]?(?:每人|每个人|各人|人人)(?:都)?(?:想要|需要|要|有|住)?(?:一间|一个|自己的|"
     r"单独的|独立的)*"
     r"(?:卧室|房间|睡房|房)", _each),
    # "客厅放一张大沙发": its size is told of no plan; "餐厅和厨房相连，厨房不要开放式": no opening
    (r"[大小](?=(?:沙发|餐桌|书桌|办公桌|衣柜|书架|书柜|冰箱|电视|镜子|茶几))", ""),
    (r"(?P<a>{lived})(?:和|与|跟|同)(?P<b>{lived})(?:之间)?(?:是|要|直接)*(?:相连|连通|连着|连接)(?=[,.;]|$)",
     _closed_there),
    # "餐厅和厨房打通，没有墙", "客厅与餐厅之间不要隔墙"
    (r"(?P<a>{lived})(?:和|与|跟|同)(?P<b>{lived})(?:之间|中间)?(?:是|要|可以|直接|全部|完全)*(?:连通|打通|贯通|"
     r"相通|相连|连在一起|"
     r"连成一[片体]|不隔开|不分隔)(?:的)?(?:[,、]?(?:之间|中间)?(?:没有|不要|不设|不用|无)(?:任何)?(?:隔断|隔墙|"
     r"墙壁?))?",
     r"\g<a>和\g<b>相通"),
    (r"(?P<a>{lived})(?:和|与|跟|同)(?P<b>{lived})(?:之间|中间)?(?:没有|不要|不设|不用|无)(?:任何)?(?:隔断|隔墙|墙壁?)",
     r"\g<a>和\g<b>相通"),
    (r"(?P<a>{lived})(?:和|与|跟|同)(?P<b>{lived})相通[,、]?(?:之间|中间)?(?:没有|不要|不设|不用|无)(?:任何)?(?"
     r":隔断|隔墙|墙壁?)",
     r"\g<a>和\g<b>相通"),
    (r"(?P<a>{any})(?:和|与|跟|同)(?P<b>{any})(?:之间)?(?:是|要|可以|直接)*(?:连通|相连|连着|连接)(?=[,.;]|$)",
     lambda found: found.group() if re.fullmatch(_LIVED, found["a"]) and re.fullmatch(_LIVED, found["b"]) else
     f"{found['a']}通向{found['b']}"),
    # "厨房和卧室不要相邻", "卫生间不能与厨房相邻", "厨房别挨着卧室"
    (r"(?P<a>{any})(?:和|与|跟|同)(?P<b>{any}){not_}(?:相邻|紧邻|挨着|紧挨着?|挨在一起|靠在一起|在一起|共用一?"
     r"[面堵]?墙)", _away),
    (r"(?P<a>{any}){not_}(?:和|与|跟|同)(?P<b>{any})(?:相邻|紧邻|挨着|紧挨着?|挨在一起|靠在一起|在一起|共用一?"
     r"[面堵]?墙)", _away),
    (r"{not_}(?:紧挨着|紧靠着|紧挨|紧靠|紧邻|紧贴|贴着|挨着|挨近|靠着|邻近|毗邻)", "不要挨着"),
    # "进门左边是厨房，右边是客厅", "厨房在入口左边，客厅在右边"
    (r"(?:{door}|一进门)的?(?P<side>[左右])(?:手边|手|边|侧|面)(?:是|为|有|放)?(?P<room>{any})"
     r"(?:[,、]?(?!(?P=side))[左右](?:手边|手|边|侧|面)(?:是|为|有)?(?P<second>{any}))?", _beside_door),
    (r"(?P<room>{any})(?:在|位于){door}的?(?P<side>[左右])(?:手边|手|边|侧|面)"
     r"(?:[,、]?(?P<second>{any})(?:在|位于)(?!(?P=side))[左右](?:手边|手|边|侧|面))?", _beside_door),
    # "父母睡主卧，两个孩子睡次卧，奶奶睡客房"
    (r"(?:我的?)?(?:父母|爸爸妈妈|爸妈|夫妻俩?|夫妇俩?|我们夫妻俩?|我和我?(?:妻子|丈夫|老婆|老公|太太))"
     r"{sleep}"
     r"(?:主卧室?|大的?(?:卧室|房间))", "主卧"),
    (r"(?:(?:[一两二三四]|\d)个)?(?:小?孩子?|儿子|女儿|男孩|女孩|宝宝)(?:们|俩|都|一起)*{sleep}"
     r"(?:次卧室?|小的?(?:卧室|房间)|儿童房|第二[间个](?:卧室|房间)?)", "儿童房"),
    (r"(?:爷爷奶奶|外公外婆|爷爷|奶奶|外公|外婆|老人){sleep}(?:客房|客卧|次卧室?|小的?(?:卧室|房间))",
     "老人房"),
    # "主卧父母住", "女儿住次卧", "一间女儿住"
    (r"(?P<room>{bed})(?:给|归|由|是)?{who}(?:们|俩)?(?:一起|自己)?(?:住|睡|用)(?:的)?(?=[,.;、]|$)", r"\g<room>"),
    (r"(?:^|(?<=[,.;、])){who}(?:们|俩)?(?:一起|自己)?(?:住|睡)在?(?P<room>{bed})(?:里)?(?=[,.;、]|$)", r"\g<room>"),
    (r"(?P<one>另外?一[间个]|一间|第[二三]间)(?:卧室)?(?:给|归|由)?(?:(?P<kid>{kid})|{who})(?:们|俩)?(?:一起|"
     r"自己)?(?:住|睡|用)(?:的)?(?=[,.;、]|$)",
     _of_whom),
    # "12到14平方米", "我的房间", "父母的房间"
    (r"(?P<low>\d+(?:\.\d+)?)(?: ?(?:平方米|平米|平|米))?(?:到|至|~)(?P<high>\d+(?:\.\d+)?)(?= ?(?:平|米|m))",
     r"\g<low>-\g<high>"),
    (r"(?P<who>我|(?:我的?)?(?:父母|爸妈|爸爸妈妈))的?(?:房间|卧室|房)(?![间子])",
     lambda found: f" {_WHOSE[re.sub('^我的?(?=.)', '', found['who'])]} "),
), lived=_LIVED, any=r"(?:[^,.;:、和与跟同在的是\d ]{1,6}?(?:厅|房|室|间|卧|卫|阳台|走廊|台))",
   sleep="(?:们|俩|都|要|会)*(?:睡|住)(?:在)?", bed=_BED, kid=_KID, who=_WHO,
   door="(?:入口|大门|进门|入户门|家门|门口)",
   not_="(?:不要|不能|不可以?|不应该?|不该|不宜|不想|别|避免|千万别)")  # fmt: skip


def in_characters(text: str) -> str:
    """A folded text with such clauses in plain words."""
    return text if text.isascii() else reworded(text, _SAID)
