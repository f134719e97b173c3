"""Draws mutants: copies of a C file with one small fault.

A mutant replaces an operator or a constant, negates a condition, or deletes a
statement, in a place that is neither a comment, a string nor a directive.
"""
import dataclasses
import re

# Each operator and what may replace it.
OPERATORS = {
    "==": ("!=",), "!=": ("==",), "<=": ("<",), ">=": (">",),
    "<": ("<=", ">"), ">": (">=", "<"), "&&": ("||",), "||": ("&&",),
    "+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "%": ("*",),
    "<<": (">>",), ">>": ("<<",), "&": ("|",), "|": ("&",),
    "+=": ("-=",), "-=": ("+=",), "*=": ("/=",), "|=": ("&=",),
    "&=": ("|=",), "++": ("--",), "--": ("++",),
}
# Binary operators have blanks on both sides, as clang-format writes them.
BINARY = re.compile(r"(?<= )(==|!=|<=|>=|&&|\|\||<<|>>|[-+*/|&]=|[-<>+*/%&|])"
                    r"(?=[ \n])")
STEP = re.compile(r"\+\+|--")
NUMBER = re.compile(r"(?<![\w.])(\d+)(\.\d+)?(f?)(?![\w.xX])")
CONDITION = re.compile(r"\b(?:if|while) \(")
STATEMENT = re.compile(r"^\t+[A-Za-z_(*][^;{}]*;$", re.M)
# Statements whose absence the compiler or the next line decides.
KEPT = re.compile(r"\s*(return|break|continue|goto|case|default|static|const|"
                  r"extern|typedef|struct \w+ \w+;|enum|\(void\)[a-z_]+;)")
# The size of an array in a declaration, of which one more changes nothing.
ARRAY = re.compile(r"^\t+(?:(?:unsigned|signed|struct|enum|const|static) )*"
                   r"[a-z_]\w* \**\w+\[[^=;]*", re.M)
DECLARATION = re.compile(r"\s*(?:(?:unsigned|signed|struct|enum|const|static) )*"
                         r"[a-z_]\w* \**\w+(\[[^\]]*\])*( = .*|, .*)?;", re.S)


@dataclasses.dataclass(frozen=True)
class Mutant:
    path: str
    line: int
    start: int
    end: int
    new: str

    def apply(self, text):
        return text[:self.start] + self.new + text[self.end:]

    def describe(self, text):
        """The file, the fault and the line, which stay when lines are added."""
        old = " ".join(text[self.start:self.end].split())
        row = text.splitlines()[self.line - 1].strip()
        what = f"without {old}" if self.new == ";" else f"{old} -> {self.new}"
        return f"{self.path}: {what} in: {row}"


def blanked(text):
    """The text with comments, strings, characters and directives as blanks, so
    that places stay what they are."""
    hidden = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|'
                        r"'(?:\\.|[^'\\\n])*'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*",
                        re.S | re.M)
    return hidden.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def closing(text, start):
    """The place behind the parenthesis that closes the one at start."""
    depth = 0
    for at in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return None


def number_mutants(found, is_size):
    digits, fraction, suffix = found.groups()
    if fraction or suffix:
        yield f"{float(digits + (fraction or '')) + 1.0}{suffix}"
    else:
        if not is_size:
            yield str(int(digits) + 1)
        if int(digits) > 0:
            yield str(int(digits) - 1)


def mutants_of(path, text):
    """All mutants of a file."""
    code = blanked(text)
    found = []

    def add(start, end, new):
        found.append(Mutant(path, text.count("\n", 0, start) + 1, start, end,
                            new))

    for match in (*BINARY.finditer(code), *STEP.finditer(code)):
        for new in OPERATORS.get(match[0], ()):
            add(match.start(), match.end(), new)
    sizes = {at for array in ARRAY.finditer(code) for at in range(*array.span())}
    for match in NUMBER.finditer(code):
        for new in number_mutants(match, match.start() in sizes):
            add(match.start(), match.end(), new)
    for match in CONDITION.finditer(code):
        end = closing(code, match.end() - 1)
        if end:
            add(match.end(), end, "!(" + text[match.end():end] + ")")
    for match in STATEMENT.finditer(code):
        if not KEPT.match(match[0]) and not DECLARATION.fullmatch(match[0]):
            add(match.start(), match.end(), ";")
    return found
