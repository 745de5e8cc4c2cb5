"""A prompt in words that the rules of rooms know: its clauses reworded one class of them after another."""

from apartgen.stages.plan.reader.advertised import advertised
from apartgen.stages.plan.reader.again import once_more
from apartgen.stages.plan.reader.as_typed import as_typed
from apartgen.stages.plan.reader.asides_told import beside_told
from apartgen.stages.plan.reader.bedded import bedded
from apartgen.stages.plan.reader.characters import in_characters
from apartgen.stages.plan.reader.commonly import commonly
from apartgen.stages.plan.reader.counted_doors import doors_counted
from apartgen.stages.plan.reader.doorside import beside_entrance
from apartgen.stages.plan.reader.entered import entered
from apartgen.stages.plan.reader.everyday import every_day
from apartgen.stages.plan.reader.everywhere import everywhere
from apartgen.stages.plan.reader.for_whom import for_whom_said
from apartgen.stages.plan.reader.furnished_with import furnished_with
from apartgen.stages.plan.reader.homely import at_home, without_false_friends
from apartgen.stages.plan.reader.in_numbers import in_numbers
from apartgen.stages.plan.reader.in_the_plan import in_the_plan
from apartgen.stages.plan.reader.in_things import in_things
from apartgen.stages.plan.reader.in_units import in_units
from apartgen.stages.plan.reader.instead_of import instead_of
from apartgen.stages.plan.reader.inverted import inverted
from apartgen.stages.plan.reader.itemized import itemized
from apartgen.stages.plan.reader.learners import as_learnt
from apartgen.stages.plan.reader.likewise import likewise
from apartgen.stages.plan.reader.lives import lived
from apartgen.stages.plan.reader.loosely import told_apart
from apartgen.stages.plan.reader.meant_of import meant_of
from apartgen.stages.plan.reader.named_again import named_again
from apartgen.stages.plan.reader.of_several_people import of_several_people
from apartgen.stages.plan.reader.on_occasion import on_occasion
from apartgen.stages.plan.reader.once_counted import once_counted
from apartgen.stages.plan.reader.one_room import in_one_room
from apartgen.stages.plan.reader.only_ways import only_ways
from apartgen.stages.plan.reader.parted import parted
from apartgen.stages.plan.reader.plainly import plainly
from apartgen.stages.plan.reader.rather import rather
from apartgen.stages.plan.reader.rephrased import rephrased
from apartgen.stages.plan.reader.round_it import round_it
from apartgen.stages.plan.reader.schedules import in_places, scheduled
from apartgen.stages.plan.reader.several_areas import of_several
from apartgen.stages.plan.reader.shared_baths import shared_by_others
from apartgen.stages.plan.reader.sides import at_sides
from apartgen.stages.plan.reader.simply import simply
from apartgen.stages.plan.reader.straightened import straightened
from apartgen.stages.plan.reader.tersely import tersely
from apartgen.stages.plan.reader.there import whose_place
from apartgen.stages.plan.reader.tokens import fold
from apartgen.stages.plan.reader.turned import turned
from apartgen.stages.plan.reader.unparted import unparted
from apartgen.stages.plan.reader.ways import in_passing
from apartgen.stages.plan.reader.whose import whose_rooms


def in_known_words(prompt: str) -> str:
    """A prompt folded, with its clauses in such words."""
    said = in_the_plan(round_it(of_several_people(furnished_with(on_occasion(fold(scheduled(prompt)))))))
    said = at_sides(tersely(in_places(in_things(in_numbers(in_units(said))))))
    said = once_counted(said)
    plain = whose_place(whose_rooms(commonly(without_false_friends(said))))
    told = every_day(at_home(everywhere(for_whom_said(simply(lived(as_typed(plain)))))))
    told = beside_entrance(in_characters(in_one_room(told)))
    told = unparted(named_again(told_apart(instead_of(shared_by_others(told)))))
    told = inverted(advertised(itemized(only_ways(meant_of(told)))))
    folded = parted(as_learnt(bedded(of_several(doors_counted(likewise(rather(straightened(told))))))))
    return rephrased(entered(in_passing(plainly(once_more(turned(beside_told(folded)))))))
