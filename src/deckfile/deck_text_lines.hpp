#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "deckfile/deck_text_scan.hpp"
#include "deckfile/deck_text_value.hpp"

namespace breccia::detail {

/// The line break of a text.
std::string newline_of(const std::string& text);

/// The begin of the line of a place, after a byte order mark.
std::size_t line_begin(const std::string& text, std::size_t at);
/// The end of the line of a place, behind its line break.
std::size_t line_end(const std::string& text, std::size_t at);
/// The end of what is in the line of a place, before its line break and the blanks there.
std::size_t content_end(const std::string& text, std::size_t at);

/// The text with whole lines before the line that begins at a place, or at the end of the text.
std::string with_lines(const std::string& text, std::size_t at, const std::vector<std::string>& lines);

/// The same, with an empty line on both sides.
std::string with_block(const std::string& text, std::size_t at, const std::vector<std::string>& lines);

/// The text with an entry in the line after an entry, with its `=` below those of the lines above, if these are
/// aligned.
std::string with_entry_after(const DeckSource& source, std::size_t statement, const EntryText& entry);

/// The begin of a block: of the comments right above its header, if there are any, or of the header itself.
std::size_t block_begin(const DeckSource& source, std::size_t header);

/// The end of a block, by its last statement: with the comments right below it, unless they are right above the header
/// of the next block.
std::size_t block_end(const DeckSource& source, std::size_t last_statement);

/// The text without all statements within a path: each entry with its line, and each block with the comments that
/// belong to it, with what is between blocks that follow one another, and with the empty lines on one side.
std::string without_statements(const DeckSource& source, DeckSteps path);

/// The text with other lines in place of all blocks within a path, at the first of them.
std::string with_blocks_replaced(const DeckSource& source, DeckSteps path, const std::vector<std::string>& lines);

}  // namespace breccia::detail
