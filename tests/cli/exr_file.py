"""Reads OpenEXR scan-line files, uncompressed or with ZIP, independently of simreel's code."""
import struct
import zlib


def read_exr(data):
    """Returns (width, height, {channel: values by rows from the top}, {attribute: (type, bytes)})."""
    if struct.unpack("<II", data[:8]) != (20000630, 2):
        raise ValueError("no OpenEXR file of scan lines")
    at, header = 8, {}

    def word():
        nonlocal at
        end = data.index(b"\0", at)
        text, at = data[at:end].decode(), end + 1
        return text

    while name := word():
        kind = word()
        (size,) = struct.unpack_from("<i", data, at)
        header[name] = (kind, data[at + 4:at + 4 + size])
        at += 4 + size
    listed, channels, k = header["channels"][1], [], 0
    while listed[k]:
        end = listed.index(b"\0", k)
        channels.append((listed[k:end].decode(), struct.unpack_from("<i", listed, end + 1)[0]))
        k = end + 17
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"][1])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    together = {0: 1, 2: 1, 3: 16}[header["compression"][1][0]]
    values = {name: [None] * height for name, _ in channels}
    formats, sizes = {0: "I", 1: "e", 2: "f"}, {0: 4, 1: 2, 2: 4}
    for (block,) in struct.iter_unpack("<q", data[at:at + 8 * ((height + together - 1) // together)]):
        y, size = struct.unpack_from("<ii", data, block)
        rows = min(together, y0 + height - y)
        raw = data[block + 8:block + 8 + size]
        if size < rows * width * sum(sizes[kind] for _, kind in channels):
            raw = undone(zlib.decompress(raw))
        place = 0
        for row in range(rows):
            for name, kind in channels:
                values[name][y - y0 + row] = struct.unpack_from(f"<{width}{formats[kind]}", raw, place)
                place += width * sizes[kind]
    return width, height, {name: [v for row in rows for v in row] for name, rows in values.items()}, header


def undone(packed):
    """Undoes the preparation for ZIP: sums the differences and interleaves the two halves."""
    summed, last = bytearray(packed), packed[0]
    for i in range(1, len(packed)):
        last = summed[i] = (last + packed[i] - 128) & 255
    half, result = (len(packed) + 1) // 2, bytearray(len(packed))
    result[0::2], result[1::2] = summed[:half], summed[half:]
    return bytes(result)


def bits(value):
    """Returns the bits of a value as a 32-bit float."""
    return struct.unpack("<I", struct.pack("<f", value))[0]


def write_exr(*parts, display=None):
    """Returns an uncompressed OpenEXR file. Each part is (width, height, {channel: (kind, values)}, {attribute: text,
    or (type, bytes)}) with kinds as in read_exr(): 0 unsigned int, 1 half, 2 float. `display` is the last pixel of the
    display window."""
    def attribute(name, kind, value):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

    formats, headers, blocks = {0: "I", 1: "e", 2: "f"}, [], []
    for number, (width, height, channels, texts) in enumerate(parts):
        listed = b"".join(name.encode() + b"\0" + struct.pack("<iiii", channels[name][0], 0, 1, 1) for name in sorted(channels))
        window = struct.pack("<4i", 0, 0, width - 1, height - 1)
        shown = struct.pack("<4i", 0, 0, *(display or (width - 1, height - 1)))
        header = (attribute("channels", "chlist", listed + b"\0") + attribute("compression", "compression", b"\0")
                  + attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", shown)
                  + attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
                  + attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
                  + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
                  + b"".join(attribute(name, *((value if isinstance(value, tuple) else ("string", value.encode()))))
                             for name, value in texts.items()))
        if len(parts) > 1:
            header += (attribute("name", "string", b"part%d" % number) + attribute("type", "string", b"scanlineimage")
                       + attribute("chunkCount", "int", struct.pack("<i", height)))
        headers.append(header + b"\0")
        rows = []
        for y in range(height):
            raw = b"".join(struct.pack(f"<{width}{formats[channels[name][0]]}", *channels[name][1][y * width:(y + 1) * width])
                           for name in sorted(channels))
            rows.append((struct.pack("<i", number) if len(parts) > 1 else b"") + struct.pack("<ii", y, len(raw)) + raw)
        blocks.append(rows)
    head = struct.pack("<II", 20000630, 2 if len(parts) == 1 else 2 | 0x1000) + b"".join(headers) + (b"\0" if len(parts) > 1 else b"")
    at = len(head) + 8 * sum(map(len, blocks))
    table, body = b"", b""
    for rows in blocks:
        for row in rows:
            table += struct.pack("<Q", at + len(body))
            body += row
    return head + table + body
