"""What the tests of the documentation read in Markdown: files, blocks of code, links, headings, mentioned commands."""
import re

BLOCK = re.compile(r"(?ms)^```([a-z]*)\n(.*?)^```\s*$")
LINK = re.compile(r"(?<!\\)\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")
SPAN = re.compile(r"`([^`\n]+)`")
HEADING = re.compile(r"(?m)^#{1,6} +(.*?)\s*#*$")
# A word in the place of a subcommand, at the start of a line of code or span: `asperity run CONFIG`.
COMMAND = re.compile(r"^\s*(?:\$ )?(?:asperity|(?:\./)?build/release/app/asperity)[ ]+(.*)$")
NOT_OURS = {"build", ".git"}


def markdown_files(root):
    """Every page of the repository, without what runs leave in outputs/."""
    pages = []
    for path in sorted(root.rglob("*.md")):
        parts = path.relative_to(root).parts
        if parts[0] in NOT_OURS or (parts[0] == "outputs" and len(parts) > 2):
            continue
        pages.append(path)
    return pages


def blocks(text):
    """(language, body) of every fenced block, in order."""
    return [(m[1], m[2]) for m in BLOCK.finditer(text)]


def without_code(text):
    return SPAN.sub("", BLOCK.sub("", text))


def links(text):
    return LINK.findall(without_code(text))


def anchors(text):
    """Addresses of a page's headings, as GitHub makes them."""
    found, seen = set(), {}
    for heading in HEADING.findall(BLOCK.sub("", text)):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "")
        slug = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(slug if count == 0 else f"{slug}-{count}")
    return found


def shell_lines(body):
    """Commands of a block: a line each, continued ones joined, without comment lines."""
    joined = body.replace("\\\n", " ")
    return [line.strip() for line in joined.splitlines() if line.strip() and not line.strip().startswith("#")]


def mentioned_commands(text):
    """What follows `asperity` in blocks and spans of code, as text."""
    lines = [line for _, body in blocks(text) for line in shell_lines(body)] + SPAN.findall(BLOCK.sub("", text))
    return [match[1] for match in map(COMMAND.match, lines) if match]
