/**
 * What the types of the package consist of: results, events and findings as plain data.
 *
 * @module data of results
 */
export type * from '../../web/model/job.js';
export type * from '../../web/model/looks.js';
export type { Message, MessageValue } from '../../web/model/message.js';
export type { FlapChoiceSide, LockKind } from '../../web/model/document-edits.js';
export type { PieceReport, ShrunkReport } from '../../web/export/report.js';
export type { Conclusion, Finding } from '../../web/model/verdict.js';
