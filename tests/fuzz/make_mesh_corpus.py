#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the starting corpus of fuzz_mesh: small files of every kind that the mesh readers know, good and bad.

    make_mesh_corpus.py FOLDER
"""
import pathlib
import struct
import sys

BOX = [(x, y, z) for z in (0.0, 7.0) for y in (0.0, 6.5) for x in (0.0, 8.0)]
FACES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
         (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def obj(faces, tail=""):
    return ("".join("v %g %g %g\n" % p for p in BOX) + "".join("f " + f + "\n" for f in faces) + tail).encode()


def ascii_stl(faces):
    out = "solid box\n"
    for f in faces:
        out += "facet normal 0 0 1\nouter loop\n" + "".join("vertex %g %g %g\n" % BOX[k] for k in f)
        out += "endloop\nendfacet\n"
    return (out + "endsolid box\n").encode()


def binary_stl(faces, count=None, header=b""):
    out = header.ljust(80, b" ") + struct.pack("<I", len(faces) if count is None else count)
    for f in faces:
        out += struct.pack("<3f", 0, 0, 1) + b"".join(struct.pack("<3f", *BOX[k]) for k in f) + b"\0\0"
    return out


def ply(encoding, faces, index="int", length="uchar", vertices=None):
    head = ("ply\nformat %s 1.0\ncomment box\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            "element face %d\nproperty list %s %s vertex_indices\nend_header\n"
            % (encoding, len(BOX) if vertices is None else vertices, len(faces), length, index)).encode()
    if encoding == "ascii":
        body = "".join("%g %g %g\n" % p for p in BOX)
        body += "".join(" ".join(map(str, (len(f),) + f)) + "\n" for f in faces)
        return head + body.encode()
    order = "<" if encoding == "binary_little_endian" else ">"
    body = b"".join(struct.pack(order + "3f", *p) for p in BOX)
    for f in faces:
        body += struct.pack(order + "B", len(f)) + b"".join(struct.pack(order + "i", k) for k in f)
    return head + body


plain = ["%d %d %d" % tuple(k + 1 for k in f) for f in FACES]
quads = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"]
FILES = {
    "obj_triangles": obj(plain),
    "obj_quads": obj(quads),
    "obj_slashes": obj(["1/1 3/1 4/1 2/1", "5//1 6//1 8//1 7//1", "1/1/1 2/1/1 6/1/1"]),
    "obj_negative": obj(["-8 -6 -5 -7", "-4 -3 -1 -2"]),
    "obj_polygon_continued": obj(["1 2 \\\n4 \\\n3 5 6"]),
    "obj_dart": b"v 0 0 0\nv 8 2 0\nv 0 4 0\nv 2 2 0\nv 3 2 7\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n",
    "obj_bow_tie": b"v 0 0 0\nv 8 8 0\nv 8 0 0\nv 0 8 1\nf 1 2 3 4\nf 4 3 2 1\n",
    "obj_notches": b"v 0 0 0\nv 9 0 0\nv 9 5 0\nv 7 5 0\nv 7 1 0\nv 5 1 0\nv 5 5 0\nv 0 5 0\nv 4 4 6\n"
                   b"f 8 7 6 5 4 3 2 1\nf 1 2 9 3 4 5 6 7 8\n",
    "obj_bridge": b"v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 3 3 0\nv 3 6 0\nv 6 6 0\nv 6 3 0\nf 1 2 3 4 1 5 6 7 8 5\n",
    "obj_marked": b"\xef\xbb\xbf" + obj(quads),
    "obj_furniture": b"# c\nmtllib gone.mtl\no a\ng b\nusemtl m\ns 1\n" + obj(quads, "l 1 2\np 1\n#MRGB 00ff\n"),
    "obj_crlf": obj(plain).replace(b"\n", b"\r\n"),
    "obj_cr": obj(plain).replace(b"\n", b"\r"),
    "obj_open": obj(plain[2:]),
    "obj_inside_out": obj([" ".join(reversed(f.split())) for f in plain]),
    "obj_nonmanifold": obj(plain + ["1 2 8", "1 2 7"]),
    "obj_collapsed": obj(plain + ["1 1 2", "3 3 3"]),
    "obj_one_triangle": obj(plain[:1]),
    "obj_index_out_of_range": obj(["1 2 9"]),
    "obj_index_zero": obj(["0 1 2"]),
    "obj_index_huge": obj(["1 2 4294967297", "1 2 -2147483649"]),
    "obj_nan": b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "obj_overflow": b"v 1e39 0 0\nv 1e999 0 0\nv 1e-999 1 0\nf 1 2 3\n",
    "obj_large": obj(plain).replace(b"7", b"3e38"),
    "prose": b"Dear Sir,\nthis is not a mesh.\n",
    "stl_ascii": ascii_stl(FACES),
    "stl_ascii_marked": b"\xef\xbb\xbf" + ascii_stl(FACES),
    "stl_ascii_cut": ascii_stl(FACES)[:400],
    "stl_ascii_case": ascii_stl(FACES).upper(),
    "stl_binary": binary_stl(FACES),
    "stl_binary_solid": binary_stl(FACES, header=b"solid box"),
    "stl_binary_cut": binary_stl(FACES)[:300],
    "stl_binary_count_lies": binary_stl(FACES, count=0xFFFFFFFF),
    "stl_binary_count_zero": binary_stl([], count=0),
    "stl_binary_tail": binary_stl(FACES) + b"tail\0",
    "stl_binary_nan": binary_stl(FACES)[:100] + b"\xff\xff\xff\x7f" + binary_stl(FACES)[104:],
    "ply_ascii": ply("ascii", FACES),
    "ply_ascii_quads": ply("ascii", [(0, 2, 3, 1), (4, 5, 7, 6)]),
    "ply_marked_dart": b"\xef\xbb\xbf" + ply("ascii", [(0, 1, 3, 2), (5, 0, 6, 3)]),
    "ply_little": ply("binary_little_endian", FACES),
    "ply_big": ply("binary_big_endian", FACES),
    "ply_big_cut": ply("binary_big_endian", FACES)[:-5],
    "ply_vertices_lie": ply("binary_little_endian", FACES, vertices=4294967295),
    "ply_float_length": ply("ascii", FACES, length="float"),
    "ply_double_index": ply("ascii", FACES, index="double"),
    "ply_no_faces": ply("ascii", []),
    "ply_empty_elements": b"ply\nformat ascii 1.0\nelement a 4294967295\nelement b 1\nproperty list uchar float k\n"
                          b"end_header\n255 1 2\n",
}

folder = pathlib.Path(sys.argv[1])
folder.mkdir(parents=True, exist_ok=True)
for name, data in FILES.items():
    (folder / name).write_bytes(data)
print(len(FILES), "files in", folder)
