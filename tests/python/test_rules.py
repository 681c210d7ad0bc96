"""Rule sets: where they come from, and what is wrong with them, as the program prints it."""

import unittest

import af2
from support import MODELS, SOURCE, Case

CLASSIC = (SOURCE / "rules/tri/classic.af2").read_text()
WRONG = """af2 1;
ruleset "mine" { elements tri; }
rule "one triangle" quality 1 {
  front a -> b;
  at    c (0.5, 0.866);
  tri   a b d;
}
"""
#: An element that lies outside of the free zone, as a counter-example proves.
UNSOUND = """af2 1;
ruleset "mine" { elements tri; }
rule "free" quality 1 {
  new  c = mid(a, b) + (0, 0.9);
  zone a, b, mid(a, b) + (0, 0.1);
  tri  a b c;
}
"""


class Loading(Case):
    def test_names_paths_and_texts_are_the_same_rules(self):
        path = self.folder / "own.af2"
        path.write_text(CLASSIC)
        made = {af2.mesh(MODELS / "cylinder.step", 1, rules=rules).fingerprint
                for rules in ("tri/classic", "tri/classic.af2", path, str(path), CLASSIC, af2.load_rules("tri/classic"))}
        self.assertEqual(len(made), 1)

    def test_shipped_names(self):
        self.assertIn("tri/even.af2", af2.rule_names())
        for name in ("tri/even", "quad/classic", "quad/paving"):
            self.assertEqual(af2.load_rules(name).makes_quads, name.startswith("quad"))
        with self.assertRaisesRegex(af2.InputError, "rules='tri/evn': there is no such file.*tri/even.af2"):
            af2.mesh(MODELS / "cylinder.step", 1, rules="tri/evn")

    def test_what_they_are(self):
        rules = af2.load_rules("tri/classic")
        self.assertIn("right 60", rules.titles)
        self.assertIn("left 60", rules.titles)
        self.assertFalse(rules.makes_quads)
        self.assertEqual(rules.diagnostics, [])

    def test_texts_may_import_shipped_files(self):
        text = (SOURCE / "rules/quad/rows.af2").read_text()
        self.assertIn('import "classic.af2"', text)
        own = text.replace('import "classic.af2"', 'import "quad/classic.af2"')
        self.assertEqual(af2.load_rules(own).titles, af2.load_rules("quad/rows").titles)


class Errors(Case):
    def test_print_like_the_program(self):
        (self.folder / "mine.af2").write_text(WRONG)
        printed = self.program("mesh", MODELS / "cylinder.step", "--size", 1, "-r", "mine.af2", code=1)
        with self.assertRaises(af2.RuleError) as caught:
            af2.Rules.from_text(WRONG, name="mine.af2")
        self.assertIn(str(caught.exception), printed)
        self.assertIn("^", str(caught.exception))

    def test_are_data(self):
        with self.assertRaises(af2.RuleError) as caught:
            af2.mesh(MODELS / "cylinder.step", 1, rules=WRONG)
        error = next(d for d in caught.exception.diagnostics if d.severity == "error")
        self.assertEqual((error.code, error.file, error.line, error.column), ("AF2-R1", "<text>", 6, 13))
        self.assertIn("'d'", error.message)
        self.assertIsInstance(error.edits, list)

    def test_unsound_rules_are_refused_unless_unchecked(self):
        with self.assertRaises(af2.RuleError) as caught:
            af2.load_rules(UNSOUND)
        self.assertIn("AF2-Z1", str(caught.exception))
        self.assertEqual(af2.load_rules(UNSOUND, check=False).titles, ["free"])

    def test_a_library_is_no_rule_set(self):
        with self.assertRaisesRegex(af2.InputError, "no rule set"):
            af2.load_rules("af2 1;\n")


class Tests(Case):
    def test_of_shipped_rules_pass(self):
        results = af2.load_rules("tri/classic").test()
        self.assertGreater(len(results), 10)
        self.assertTrue(all(result.passed for result in results))
        self.assertTrue(str(results[0]).startswith("ok"))
        only = af2.load_rules("tri/classic").test("60")
        self.assertTrue(0 < len(only) < len(results))

    def test_failures_say_what_was_expected(self):
        text = CLASSIC + '\ntest "wrong" {\n  front a (0, 0) -> b (1, 0) -> c (0.5, 0.9);\n  expect rule "left 60";\n}\n'
        rules = af2.load_rules(text)
        failed = [result for result in rules.test() if not result.passed]
        self.assertEqual([result.title for result in failed], ["wrong"])
        self.assertIn("left 60", failed[0].failures[0].expected)
        self.assertTrue(str(failed[0]).startswith("FAIL"))


class Evaluation(Case):
    def test_is_that_of_the_program(self):
        found = af2.load_rules("tri/classic").evaluate("right 60", {"c": (0.5, 0.9)}, points=[(0.5, 0.3), (3, 3)],
                                                       segments=[((0, -1), (0.5, 2))])
        self.assertTrue(found["matches"])
        self.assertEqual(found["points_in_zone"], [True, False])
        self.assertEqual(found["segments_meet_zone"], [True])
        printed = self.program("eval", SOURCE / "rules/tri/classic.af2", "--rule", "right 60", "--match", "c=0.5,0.9",
                               "--point", "0.5,0.3", "--point", "3,3", "--segment", "0,-1,0.5,2")
        self.assertEqual(found["text"], printed)

    def test_faults(self):
        rules = af2.load_rules("tri/classic")
        with self.assertRaisesRegex(af2.InputError, "no such"):
            rules.evaluate("no such")
        with self.assertRaises(af2.InputError):
            rules.evaluate("right 60", {"z": (0, 0)})


class Trace(Case):
    def test_tells_every_step(self):
        steps = []
        mesh = af2.mesh(MODELS / "plate.poly", size=0.5, rules="tri/classic", threads=1, optimize=False, trace=steps.append)
        applied = [step for step in steps if step.applied]
        self.assertLess(len(applied), len(steps) + 1)
        made = {mesh.rule_names[i] for i in mesh.rule[mesh.level > 0]}
        self.assertEqual({mesh.rule_names[step.rule] for step in applied}, made)
        self.assertEqual(applied[-1].front_edges, 0)
        self.assertGreaterEqual(applied[-1].elements, 1)
        refused = [step for step in steps if not step.applied]
        self.assertTrue(all(len(step.refusals) == len(mesh.rule_names) - 2 or step.refusals for step in refused))
        self.assertEqual({step.face for step in steps}, {1})

    def test_errors_stop_the_run(self):
        def stop(step):
            raise InterruptedError("seen enough")

        with self.assertRaisesRegex(InterruptedError, "seen enough"):
            af2.mesh(MODELS / "die.step", size=0.2, trace=stop)


if __name__ == "__main__":
    unittest.main()
