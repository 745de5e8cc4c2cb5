"""Chinese walls that are not there, rooms that are not neighbours, and whose rooms are whose."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader.characters import in_characters

SAID = [
    ("两居室，餐厅和厨房打通，没有墙。", "B2 D H K L W", "D1~K1"),
    ("两室一厅，客厅和餐厅之间没有隔墙。", "B2 D H K L W", "D1~L1"),
    ("一室一厅，厨房与客厅连通。", "B H K L W", "K1~L1"),
    ("两室，主卧和卫生间相连。", "B2 H K L W", "B1W1"),
    ("两室，客厅和阳台连通。", "B2 H K L W Y", "L1Y1, !L1~Y1"),
    ("两室，厨房别挨着卧室。", "B2 H K L W", "apart K1 B1, !adjacent K1 B1"),
    ("两室，厨房和主卧不要相邻。", "B2 H K L W", "apart K1 B1"),
    ("两室，书房不能与卫生间相邻。", "B2 H K L S W", "apart S1 W1"),
    ("两居室，书房在入口左边，厨房在右边。", "B2 H K L S W", "position S1 entrance left, position K1 entrance right"),
    ("两居室，进门右手边是厨房，左手边是客厅。", "B2 H K L W", "position K1 entrance right, position L1 entrance left"),
    ("一套70到80平方米的两居室，主卧13到15平方米。", "B2 H K L W",
     "at_least home 70, at_most home 80, at_least B1 13, at_most B1 15"),
    ("我的房间12平方米，父母的房间15平方米。", "B2 H K L W", "B1=15, B2=12"),
    ("父母的房间挨着阳台，我的房间朝南。", "B2 H K L W Y", "adjacent B1 Y1, orientation B2 south"),
    ("四个同学合租，每人一个房间，两个卫生间。", "B4 H K L W2", ""),
    ("五个同事合租，每人一间房，三个卫生间。", "B5 H K L W3", ""),
    ("三个室友，每个人都有自己的房间。", "B3 H K L W2", ""),
    ("两个卧室，我的朝东，他的朝北。", "B2 H K L W", "orientation B1 east, orientation B2 north"),
    ("书房只能从客厅进入，两个卧室。", "B2 H K L S W", "L1S1, !H1S1"),
    ("两个卧室，卫生间在它们之间。", "B2 H K L W", "B1W1, B2W1"),
    ("客厅面积至少是厨房的三倍。两居室。", "B2 H K L W", "K1=8.75, L1=26.24"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SAID)


@pytest.mark.parametrize("text", ["two bedrooms and a bath", "两室一厅,阳台朝南"])
def test_other_text_stays(text):
    assert in_characters(text) == text
