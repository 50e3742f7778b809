"""Makes a page of pairs: for each scene a row of pictures (draft, standard, high and Cycles) with their times. Needs
python3-pil."""
import io
import pathlib

from PIL import Image, ImageDraw, ImageFont

FONT = pathlib.Path(__file__).resolve().parents[2] / "assets/fonts/OpenSans-Regular.ttf"
COLUMNS = {"draft": "draft", "standard": "standard", "high": "high", "cycles": "Cycles"}
MAX_BYTES, GAP, LABEL, WIDTH = 100_000, 4, 22, 320


def row(measured, folder):
    """Returns a PNG with a palette, in the largest width that fits into MAX_BYTES."""
    for width in (WIDTH, 280, 240, 200, 160):
        height = width * measured["size"][1] // measured["size"][0]
        page = Image.new("RGB", (4 * width + 3 * GAP, height + LABEL), "white")
        drawn, font = ImageDraw.Draw(page), ImageFont.truetype(str(FONT), 13)
        for i, (name, label) in enumerate(COLUMNS.items()):
            left = i * (width + GAP)
            page.paste(Image.open(folder / f"{name}.png").convert("RGB").resize((width, height), Image.Resampling.LANCZOS), (left, LABEL))
            took = measured["seconds"][name]["processor"]
            samples = {"high": f", {measured['samples']['simreel']} samples", "cycles": f", {measured['samples']['cycles']} samples"}.get(name, "")
            drawn.text((left + 2, 2), f"{label}{samples}: {took:.1f} s", fill="black", font=font)
        data = io.BytesIO()
        page.quantize(256, method=Image.Quantize.MEDIANCUT, kmeans=8, dither=Image.Dither.FLOYDSTEINBERG).save(data, "PNG", optimize=True)
        if data.tell() <= MAX_BYTES:
            return data.getvalue()
    raise SystemExit(f"no size brings {measured['scene']} below {MAX_BYTES} bytes")


def write_page(page, rows):
    page.parent.mkdir(parents=True, exist_ok=True)
    lines = ["# simreel beside Cycles", "",
             "`tools/cycles/compare --page assets/gallery/pairs.md tools/cycles/scenes/{creature,tablecloth,torus}.json` made this page (samples of Cycles: `--cycles`): scenes of [tools/cycles/scenes](../../tools/cycles/scenes), whose meshes `simreel bake` hands to Blender; light and",
             "materials are the same, bounces limited to one, the view \"Standard\" (`\"tone\": \"plain\"`). Seconds are of processors, with start and compiling; FLIP is the mean error of `high` against Cycles.", "",
             "| scene | size | FLIP | high: samples | processor s | wall s | Cycles: samples | processor s | wall s |", "|---|---|---|---|---|---|---|---|---|"]
    for measured, _ in rows:
        high, cycles, samples = measured["seconds"]["high"], measured["seconds"]["cycles"], measured["samples"]
        lines.append(f"| {measured['scene']} | {'x'.join(map(str, measured['size']))} | {measured['flip']:.3f} | {samples['simreel']} | {high['processor']:.0f} | {high['wall']:.0f} "
                     f"| {samples['cycles']} | {cycles['processor']:.0f} | {cycles['wall']:.0f} |")
    for measured, folder in rows:
        picture = page.with_name(f"{page.stem}_{measured['scene']}.png")
        picture.write_bytes(row(measured, folder))
        lines += ["", f"{measured['title']}:", "", f"![{measured['title']}: draft, standard, high, Cycles]({picture.name})"]
    page.write_text("\n".join(lines) + "\n")
