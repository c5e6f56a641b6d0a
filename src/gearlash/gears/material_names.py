"""What drawings call materials, words and designations of EN, AISI, JIS, BS and GB, as names of the list.

A designation stands for an entry only where its modulus lies in the range of that entry: austenitic steels,
grey iron of classes other than 250 and 300, and aluminium bronze have other ones.
"""

from __future__ import annotations

import re

from gearlash.system.nearest import nearest

WORDS = {
    "steel": (
        "stahl", "carbonsteel", "alloysteel", "forgedsteel", "hardenedsteel", "casehardenedsteel",
        "casehardeningsteel", "casecarburizedsteel", "carburizedsteel", "carburisedsteel", "nitridedsteel",
        "throughhardenedsteel", "inductionhardenedsteel", "heattreatablesteel", "einsatzstahl",
        "vergütungsstahl", "nitrierstahl", "baustahl", "acier",
    ),
    "cast-steel": ("steelcasting", "stahlguss", "stahlguß"),
    "nodular-cast-iron": (
        "nodulariron", "nodularcastiron", "ductileiron", "ductilecastiron", "spheroidalgraphiteiron",
        "spheroidalgraphitecastiron", "sgiron", "sphäroguss", "kugelgraphitguss",
    ),
    "grey-cast-iron": ("greyiron", "grayiron", "graycastiron", "lamellargraphitecastiron", "grauguss"),
    "tin-bronze": ("phosphorbronze", "zinnbronze", "gunmetal"),
    "brass": ("messing", "laiton"),
    "aluminium": ("aluminum", "alu"),
    "POM": ("acetal", "polyacetal", "delrin", "hostaform", "duracon", "pomc", "pomh", "polyoxymethylene"),
    "PA66": ("nylon66", "polyamide66"),
}  # fmt: skip
"""Small letters without signs between them."""
_LOW_ALLOY = r"\d{2}(?:Cr|Mn|Mo|Ni|V|Si|B|Al|Ti|S|Pb)+(?:\d[\d-]*[A-Z]?)?"
_OF_GB = r"\d{2}(?:(?:Cr|Mn|Mo|Ni|V|Si|B|Al|Ti|W)[1-4]?)+[AHE]{0,2}"
_SAE = (
    r"10(?:0[568]|1[0-35-9]|2[0-36]|25|29|3[03-579]|38|4[02-69]|5[0359]|6[0459]|7[0458]|8[0456]|9[05])"
    r"|11(?:0[89]|1[06-9]|32|37|39|4[01456]|51)|41(?:18|2[01]|3[0157]|4[0257]|50|61)|43[24]0"
    r"|46(?:15|17|2[016])|47(?:15|18|20)|48(?:15|17|20)|51(?:15|17|20|3[0257]|35|4[057]|5[05]|60)"
    r"|61(?:18|50)|81(?:15)|86(?:15|17|2[0257]|3[057]|4[0257]|5[05]|60)|87(?:20|40|50)|88(?:22)|9310"
)
"""Grades of SAE J403 and J404."""
OF_ALUMINIUM = ("1050", "1060", "1065", "1070", "1080", "1085", "1090", "1110", "1145")
"""Grades of SAE whose numbers wrought aluminium has, too: bare they say neither."""
DESIGNATIONS = {
    "steel": (
        rf"(?:{_LOW_ALLOY}|C\d{{2}}[ERC]?|C[kfmq]\d{{2}}|(?:S(?:235|275|355|420|460|690)|E(?:295|335|360))(?:[JKN][A-Z0-9]{{0,3}})?)(?:\+\w+|V|N|G)*",
        r"1\.(?:0|1|5|6|7|8)\d{3}(?:\+\w+)*",
        rf"(?:AISI|SAE|ASTM)(?:{_SAE})H?(?:STEEL)?|(?:{_SAE})(?:HSTEEL|STEEL)",
        rf"(?!(?:{'|'.join(OF_ALUMINIUM)})$)(?:{_SAE})H?",
        _OF_GB,
        r"(?:08|10|15|20|25|30|35|40|45|50|55|60)(?:#|STEEL|号钢|钢)",
        r"EN(?:[1-9]|[1-4]\d|35[1-5]|36[123]|100|110)[A-Z]?",
        r"(?:JIS)?(?:S\d{2}C|S\d{2}CK|SCM\d{3}|SNCM\d{3}|SNC\d{3}|SCr\d{3}|SMn\d{3})H?(?:JIS)?",
        r"(?:BS970)?(?:0|1|2|5|6|7|8)\d{2}[AMH]\d{2}",
    ),
    "cast-steel": (r"GS-?\d{2}", r"G\d{2}(?:Cr|Mn|Mo|Ni)+\d[\d-]*", r"ZG\d{3}-\d{3}"),
    "nodular-cast-iron": (
        r"(?:EN-?)?GJS-?(?:350|400|450|500|600|700)(?:-\d+\w*(?:-[RL]T)?)?",
        r"GGG-?\d{2}(?:\.\d)?",
        r"FCD-?\d{3}",
        r"QT-?(?:400|450|500|600|700)(?:-\d+[A-Z]?)?",
        r"5\.31\d{2}",
    ),
    "grey-cast-iron": (
        r"(?:EN-?)?GJL-?(?:250|300)",
        r"GG-?(?:25|30)",
        r"(?:FC|HT)-?(?:250|300)",
        r"5\.130[12]",
    ),
    "tin-bronze": (
        r"G?[ZC]?-?CuSn(?:10|11|12)(?:Ni\d?|P\d?|Pb\d?)*(?:-C|-G[CZS])?",
        r"CC48[0-4]K",
        r"C90[57]00|C91700",
        r"PB[12]",
    ),
    "brass": (r"CuZn(?:3[5-9]|40)(?:Pb\d?)?", r"CW6(?:03|08|14|17)N", r"C3[67]0{3}|C38500"),
    "aluminium": (
        r"(?:(?:EN)?-?AW-?|AA-?)(?:1\d{3}|[567]\d{3})A?(?:-?[THO]\d*)?",
        r"(?:6061|6082|7075)(?:-?T\d+)?",
    ),
    "PA66-GF30": (r"PA66-?GF-?30",),
}  # fmt: skip
"""By material: designations whose modulus is that of the list, without blanks."""
_PATTERNS = {
    name: re.compile("|".join(f"(?:{each})" for each in patterns)) for name, patterns in DESIGNATIONS.items()
}
_CASELESS = {name: re.compile(pattern.pattern, re.IGNORECASE) for name, pattern in _PATTERNS.items()}
NEAR = {
    "castiron": "grey-cast-iron", "gusseisen": "grey-cast-iron", "bronze": "tin-bronze", "nylon": "PA66",
    "pa": "PA66", "pa6": "PA66", "pa46": "PA66", "polyamide": "PA66", "pom": "POM", "stainless": "steel",
    "stainlesssteel": "steel", "adi": "nodular-cast-iron", "sinteredsteel": "steel",
}  # fmt: skip
"""Words that mean several materials, or one that is near."""
_NEAR = {
    "grey-cast-iron": r"(?:en-?)?gjl.*|gg-?\d.*|fc-?\d.*|ht-?\d.*",
    "nodular-cast-iron": r"(?:en-?)?gjs.*|ggg.*|fcd.*|qt-?\d.*",
    "steel": r"x\d.*|1\.\d{4}|sus\d.*|\d{3}L?|17-?4.*|en5\d[a-z]?|45|\d{2}cr.*|.*(?:steel|stahl)",
    "tin-bronze": r".*bronze|.*cual.*|cc\d{3}.*|.*cusn.*|qsn.*|pb\d+",
    "brass": r"cuzn.*|cw\d{3}.*",
    "aluminium": r"(?:en)?-?a[wc]-?.*|alsi.*|alzn.*|almg.*|[1-8]\d{3}-?[tho]\d+|[23567]\d{3}|1100",
    "PA66": r"pa\d+.*",
    "POM": r"pom.*",
}


def listed_name(name: str, names: tuple[str, ...]) -> str | None:
    """The name of the list that a text stands for.

    Parameters
    ----------
    name : str
    names : tuple of str
        Of the list.

    Returns
    -------
    str or None
        None where it stands for none, or for several.

    Examples
    --------
    >>> from gearlash.gears.material_names import listed_name
    >>> listed_name("EN-GJS-400-15", ("steel", "nodular-cast-iron"))
    'nodular-cast-iron'
    >>> listed_name("cast iron", ("steel", "nodular-cast-iron"))
    """
    word, bare = _word(name), re.sub(r"\s+", "", name.strip())
    for key in names:
        if _word(key) == word or word in WORDS.get(key, ()):
            return key
    for patterns in (_PATTERNS, _CASELESS):
        found = [key for key in names if key in patterns and patterns[key].fullmatch(bare)]
        if len(found) == 1:
            return found[0]
    return None


def of_two_materials(name: str) -> str:
    """What a number may be that is one of steel and one of aluminium; empty for all others.

    Parameters
    ----------
    name : str

    Returns
    -------
    str

    Examples
    --------
    >>> from gearlash.gears.material_names import of_two_materials
    >>> of_two_materials("1050")
    'AISI 1050 of steel or AA 1050 of aluminium'
    """
    number = name.strip()
    return f"AISI {number} of steel or AA {number} of aluminium" if number in OF_ALUMINIUM else ""


def nearest_material(name: str, names: tuple[str, ...]) -> str | None:
    """The name of the list that is next to a text which stands for none.

    Parameters
    ----------
    name : str
    names : tuple of str

    Returns
    -------
    str or None

    Examples
    --------
    >>> from gearlash.gears.material_names import nearest_material
    >>> nearest_material("cast iron", ("steel", "grey-cast-iron"))
    'grey-cast-iron'
    """
    word, bare = _word(name), re.sub(r"\s+", "", name.strip()).casefold()
    if NEAR.get(word) in names:
        return NEAR[word]
    found = [key for key in names if key in _NEAR and re.fullmatch(_NEAR[key], bare, re.IGNORECASE)]
    return found[0] if found else nearest(name, names)


def _word(name: str) -> str:
    return re.sub(r"[\W_]", "", name.casefold())
