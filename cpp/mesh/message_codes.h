#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace foldwright {

/// The codes of all that the engine tells people: failures, repairs, notices. They are stable words
/// for programs; `web/words` has a sentence for each.
inline constexpr std::array kMessageCodes = std::to_array<std::string_view>({
    // Files that cannot be read.
    "bad-header",
    "bad-index",
    "bad-number",
    "bad-size",
    "bad-syntax",
    "bad-text",
    "empty-file",
    "no-area",
    "no-faces",
    "no-model",
    "not-finite",
    "several-models",
    "too-many-corners",
    "truncated",
    "unknown-format",
    // What was mended or noticed in a model.
    "closed-cracks",
    "closed-t-junctions",
    "crossing-bodies",
    "crossings-unchecked",
    "counts-from-zero",
    "cut-nonorientable",
    "cut-off",
    "decimal-commas",
    "dropped-degenerate-faces",
    "dropped-duplicate-faces",
    "dropped-inner-bodies",
    "dropped-misnumbered-faces",
    "dropped-placeless-faces",
    "dropped-unused-vertices",
    "filled-holes",
    "flat-bodies",
    "flattened-faces",
    "flipped-faces",
    "halved-edges",
    "huge-holes",
    "ignored-elements",
    "inner-bodies",
    "lost-picture-places",
    "merged-two-sided",
    "missing-endsolid",
    "not-united",
    "open-border",  // also an edit that cannot be made
    "open-holes",
    "other-format",
    "self-crossing-bodies",
    "split-nonmanifold-edges",
    "split-nonmanifold-vertices",
    "step-off",
    "trailing-bytes",
    "trailing-lines",
    "triangulated-polygons",
    "unfilled-holes",
    "united-bodies",
    "welded-vertices",
    "wrong-count",
    // What cannot be done with a model.
    "bad-edit",
    "bad-margin",
    "bad-option",
    "bad-pin",
    "bad-start",
    "face-too-large",
    "internal",
    "no-depth",
    "no-height",
    "no-width",
    "out-of-memory",
    "too-few-sheets",
    "too-many-faces",
    // Edits of nets that cannot be made.
    "already-cut",
    "already-joined",
    "inside-panel",
    "locked",
    "no-edge",
    "no-face",
    "no-net",
    "no-part",
    "not-in-loop",
    "not-touching",
    "overlap",
    "would-fall-apart",
    // What to know about a result.
    "colour-numbers",
    "faces-above-wish",
    "files-ignored",
    "joints",
    "joints-lost",
    "large-model",
    "meets-itself",
    "no-motion",
    "part-split",
    "parts-lowered",
    "parts-raised",
    "pin-lost",
    "sheet-split",
    "small-bodies",
    "smaller-saves-sheets",
    "unchecked-pieces",
    "unit-guessed",
    "up-guessed",
    "weak-necks",
});

constexpr bool is_message_code(std::string_view word) {
  return std::ranges::find(kMessageCodes, word) != kMessageCodes.end();
}

}  // namespace foldwright
