#pragma once

// CLI11's own header takes seconds in each source that includes it, because it defines objects in
// each: only sources that add or read options do so.
namespace CLI {
class App;
class Option;
class ParseError;
class Validator;
}  // namespace CLI
