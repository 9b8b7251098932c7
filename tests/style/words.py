"""Words that the project gave up for the field's own terms, and where each may still stand: in aliases.

IDENTIFIERS are whole words, case matters. PHRASES are regular expressions, case does not matter; a space in one also
stands for a line break inside a comment or a string. Ordinary uses of ordinary words are not listed.
"""
import re

IDENTIFIERS = """
    standers stander movers mover StillMap stillMap stillCasters stillAnswers stillIds StillVersions
    touchedByMover keptAnswers noKeep no_keep noPlan no_plan
    RestingPixels framesToRest restOf mayRest woken waking
    overruled ruleAll PrimaryRuling ShadowRuling
    MotionMemory decidedAnew FrameSequel cameToRest
    Visits MOST_VISITS NO_VISIT VISIT_GAP visitAt visitsOf
    Backdrop backdrop backdrops crossedInPairs
    TruthTechnique truth_technique EmbreePeer embree_peer peer peers
    effort efforts EffortSearch effort_search TechniqueFigure beware Beware oddLists
""".split()

PHRASES = [
    # code, comments, README
    r"(?:still|moving) (?:map|casters|versions) alone", r"kept answers", r"answers? kept", r"no question twice",
    r"--no-keep", r"--no-plan",
    r"resting pixels?", r"pixels? rests?", r"learned enough", r"pixels? (?:is|are) woken",
    r"\bwakes? (?:it|them|pixels?)\b",
    r"\brul(?:ed|ings?)\b(?! out)", r"\bsequels?\b", r"bending triangles?", r"(?:two|odd|no|of) visits",
    r"nothing lies behind", r"nothing behind", r"crossed in pairs", r"enters? (?:\w+ ){0,4}leaves? (?:it )?again",
    r"technique's clothes", r"figures of (?:a|the|each|every) technique", r"technique's figures",
    r"\bmiddles?\b (?:of (?:a|the|its|each|every) )?texels?", r"texels?'s? middles?",
    r"\b(?:MOST|LARGEST)_[A-Z]", r"\bodd (?:lists?|counts?)\b",
    r"shadow answers?", r"wrong answers?", r"shadow questions?", r"(?:pixels?|samples?|texels?) (?:is|are) asked",
    r"asks? (?:the )?(?:technique|oracle|truth|map|triangle)s?\b", r"the truth (?:does not )?asks?", r"nobody is asked",
    r"window depth", r"to the letter", r"hard cases?",
    # the window
    r'"(?:\{\}|%d|[0-9]+)? ?kinds?"', r'"(?:\{\}|%d|[0-9]+) (?:a pixel|a second|cells)"', r'" (?:a pixel|a second)"',
    r"\"[^\"\n]*light's map", r"settings of now", r"exchange the two", r"right as it is", r'"as it is"', r"\berrs by\b",
    r"no picture yet", r"opened before", r"receivers shadow themselves", r"of real time", r"shaders anew",
    r"a frame back",
]

# File -> what it may say: old names that older command lines, settings files and journals may hold.
ALIASES = {
    "tests/style/words.py": None,
    "tests/style/words_test.py": None,
    "app/options/frame_options.cpp": ("--no-plan", "--no-keep"),
    "renderer/measure/verification_json.cpp": ("ruled", "overruled"),
    "tests/unit/verification_json_test.cpp": ("ruled", "overruled"),
}

SEPARATOR = r'(?:[ \t]*"?\n[ \t]*(?://[/!<]*|\#|\*|")?[ \t]*|[ \t]+)'
PATTERN = re.compile("|".join([rf"(?<![A-Za-z0-9_])(?:{'|'.join(IDENTIFIERS)})(?![A-Za-z0-9_])"]
                              + [f"(?i:{phrase.replace(' ', SEPARATOR)})" for phrase in PHRASES]))


def found(text):
    """(line, word) for each that stands in the text."""
    return [(text.count("\n", 0, match.start()) + 1, " ".join(match.group(0).split()))
            for match in PATTERN.finditer(text)]


def forbidden(path, text):
    allowed = ALIASES.get(path, ())
    if allowed is None:
        return []
    return [(line, word) for line, word in found(text) if word not in allowed]
